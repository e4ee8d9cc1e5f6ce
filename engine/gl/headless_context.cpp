// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/headless_context.h"

#include <array>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include <epoxy/gl.h>

#include <epoxy/egl.h>
#include <fmt/format.h>

#include "gl/driver.h"
#include "gl/driver_cache.h"

namespace patina::gl {
namespace {

constexpr const char* needed = "OpenGL 4.1 core without a window (EGL)";

bool clientExtension(std::string_view name) {
    const char* all = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    return all != nullptr && std::string_view(all).find(name) != std::string_view::npos;
}

/// Counts the headless contexts on each EGL display, and terminates a display with its last one.
/// Threads may share it.
class OwnDisplays {
  public:
    bool open(EGLDisplay display) {
        const std::lock_guard lock(mutex_);
        const bool isOpen = eglInitialize(display, nullptr, nullptr) == EGL_TRUE;
        contexts_[display] += isOpen ? 1 : 0;
        return isOpen;
    }

    void close(EGLDisplay display) {
        const std::lock_guard lock(mutex_);
        if (--contexts_[display] == 0) {
            eglTerminate(display);
        }
    }

  private:
    std::mutex mutex_;
    std::map<EGLDisplay, int> contexts_;
};

OwnDisplays& ownDisplays() {
    static OwnDisplays displays;
    return displays;
}

void addDevices(std::vector<EGLDisplay>& displays) {
    if (!clientExtension("EGL_EXT_platform_device") ||
        !clientExtension("EGL_EXT_device_enumeration")) {
        return;
    }
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count);
    for (EGLint i = 0; i < count; ++i) {
        displays.push_back(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(i)], nullptr));
    }
}

/// Lists the displays in the order in which they are tried.
std::vector<EGLDisplay> candidateDisplays() {
    std::vector<EGLDisplay> displays;
    if (clientExtension("EGL_MESA_platform_surfaceless")) {
        displays.push_back(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
    addDevices(displays);
    displays.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    return displays;
}

EGLContext coreContext(EGLDisplay display, bool debug) {
    const std::array<EGLint, 9> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                           4,
                                           EGL_CONTEXT_MINOR_VERSION,
                                           1,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                           EGL_CONTEXT_OPENGL_DEBUG,
                                           debug ? EGL_TRUE : EGL_FALSE,
                                           EGL_NONE};
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
}

bool makeCurrent(EGLDisplay display, EGLContext context) {
    return context != EGL_NO_CONTEXT &&
           eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
}

/// Returns a phrase for errors: which OpenGL the display offers when any version will do.
std::string offered(EGLDisplay display) {
    const std::array<EGLint, 1> none{EGL_NONE};
    EGLContext any = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, none.data());
    if (!makeCurrent(display, any)) {
        return "no OpenGL context could be made";
    }
    std::string found = fmt::format("found only OpenGL {}", driverText());
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, any);
    return found;
}

} // namespace

Result<std::unique_ptr<HeadlessContext>> HeadlessContext::create(const Options& options) {
    prepareDriverCache();
    std::string found;
    for (EGLDisplay display : candidateDisplays()) {
        if (display == EGL_NO_DISPLAY || !ownDisplays().open(display)) {
            continue;
        }
        EGLContext context = EGL_NO_CONTEXT;
        if (eglBindAPI(EGL_OPENGL_API) == EGL_TRUE) {
            context = coreContext(display, options.debug);
        }
        if (makeCurrent(display, context) && epoxy_gl_version() >= 41) {
            return std::unique_ptr<HeadlessContext>(new HeadlessContext(display, context));
        }
        found = found.empty() ? offered(display) : found;
        ownDisplays().close(display);
    }
    return failure(found.empty() ? "found no usable EGL display" : found, needed);
}

HeadlessContext::~HeadlessContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    ownDisplays().close(display_);
}

} // namespace patina::gl
