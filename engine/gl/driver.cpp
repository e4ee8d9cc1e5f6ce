// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/driver.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <epoxy/gl.h>
#include <fmt/format.h>

namespace patina::gl {
namespace {

std::string text(GLenum name) {
    const GLubyte* value = glGetString(name);
    return value == nullptr ? "unknown" : reinterpret_cast<const char*>(value);
}

} // namespace

std::string driverText() {
    return fmt::format("{} on {} by {}", text(GL_VERSION), text(GL_RENDERER), text(GL_VENDOR));
}

bool isSoftware() {
    const std::string renderer = text(GL_RENDERER);
    constexpr std::array<std::string_view, 5> names{"llvmpipe", "softpipe", "swrast", "SwiftShader",
                                                    "Software"};
    return std::ranges::any_of(names, [&](std::string_view name) {
        return renderer.find(name) != std::string::npos;
    });
}

bool hasBaseInstances() {
    return epoxy_gl_version() >= 42 || epoxy_has_gl_extension("GL_ARB_base_instance");
}

int largestUniformBlock() {
    GLint bytes = 0;
    glGetIntegerv(GL_MAX_UNIFORM_BLOCK_SIZE, &bytes);
    return std::max(bytes, 16384);
}

Result<void> checkVersion() {
    if (epoxy_is_desktop_gl() && epoxy_gl_version() >= 41) {
        return {};
    }
    return failure(fmt::format("found only OpenGL {}", driverText()), "OpenGL 4.1 core or newer");
}

} // namespace patina::gl
