// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/driver.h"

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

Result<void> checkVersion() {
    if (epoxy_is_desktop_gl() && epoxy_gl_version() >= 41) {
        return {};
    }
    return failure(fmt::format("found only OpenGL {}", driverText()), "OpenGL 4.1 core or newer");
}

} // namespace patina::gl
