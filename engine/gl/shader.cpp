// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/shader.h"

#include <epoxy/gl.h>

namespace patina::gl {
namespace {

std::string compileLog(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(length), '\0');
    glGetShaderInfoLog(shader, length, &length, text.data());
    text.resize(static_cast<std::size_t>(length));
    return text;
}

} // namespace

void deleteShader(unsigned name) {
    glDeleteShader(name);
}

tl::expected<Shader, std::string> Shader::compile(unsigned stage, std::string_view source) {
    Shader shader;
    shader.name_ = Name<deleteShader>(glCreateShader(stage));
    const char* text = source.data();
    const auto length = static_cast<GLint>(source.size());
    glShaderSource(shader.name(), 1, &text, &length);
    glCompileShader(shader.name());
    GLint compiled = 0;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == 0) {
        return tl::unexpected(compileLog(shader.name()));
    }
    return shader;
}

} // namespace patina::gl
