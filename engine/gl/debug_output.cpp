// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/debug_output.h"

#include <epoxy/gl.h>

namespace patina::gl {
namespace {

/// Appends a message to `user`, a vector of strings. Messages of the shader compiler are dropped,
/// since they are in the shader's log and reported from there.
void APIENTRY collect(GLenum source, GLenum, GLuint, GLenum severity, GLsizei length,
                      const GLchar* message, const void* user) {
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION || source == GL_DEBUG_SOURCE_SHADER_COMPILER) {
        return;
    }
    auto* messages = static_cast<std::vector<std::string>*>(const_cast<void*>(user));
    messages->emplace_back(message, static_cast<std::size_t>(length));
}

} // namespace

DebugOutput::DebugOutput()
    : available_(epoxy_gl_version() >= 43 || epoxy_has_gl_extension("GL_KHR_debug")) {
    if (available_) {
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(collect, &messages_);
    }
}

DebugOutput::~DebugOutput() {
    if (available_) {
        glDebugMessageCallback(nullptr, nullptr);
        glDisable(GL_DEBUG_OUTPUT);
    }
}

} // namespace patina::gl
