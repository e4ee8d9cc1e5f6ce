// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/program.h"

#include <epoxy/gl.h>

namespace patina::gl {
namespace {

bool linked(GLuint program) {
    GLint status = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &status);
    return status != 0;
}

std::string linkLog(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(length), '\0');
    glGetProgramInfoLog(program, length, &length, text.data());
    text.resize(static_cast<std::size_t>(length));
    return text;
}

bool driverHasFormat(unsigned format) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &count);
    std::vector<GLint> formats(static_cast<std::size_t>(count));
    if (count > 0) {
        glGetIntegerv(GL_PROGRAM_BINARY_FORMATS, formats.data());
    }
    for (const GLint offered : formats) {
        if (static_cast<unsigned>(offered) == format) {
            return true;
        }
    }
    return false;
}

} // namespace

void deleteProgram(unsigned name) {
    glDeleteProgram(name);
}

tl::expected<Program, std::string> Program::link(const Shader& vertex, const Shader& fragment,
                                                 const Shader* geometry) {
    Program program;
    program.name_ = Name<deleteProgram>(glCreateProgram());
    glProgramParameteri(program.name(), GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
    glAttachShader(program.name(), vertex.name());
    glAttachShader(program.name(), fragment.name());
    if (geometry != nullptr) {
        glAttachShader(program.name(), geometry->name());
    }
    glLinkProgram(program.name());
    glDetachShader(program.name(), vertex.name());
    glDetachShader(program.name(), fragment.name());
    if (geometry != nullptr) {
        glDetachShader(program.name(), geometry->name());
    }
    if (!linked(program.name())) {
        return tl::unexpected(linkLog(program.name()));
    }
    return program;
}

std::optional<Program> Program::load(const ProgramBinary& binary) {
    if (binary.bytes.empty() || !driverHasFormat(binary.format)) {
        return std::nullopt;
    }
    Program program;
    program.name_ = Name<deleteProgram>(glCreateProgram());
    glProgramBinary(program.name(), binary.format, binary.bytes.data(),
                    static_cast<GLsizei>(binary.bytes.size()));
    if (!linked(program.name())) {
        return std::nullopt;
    }
    return program;
}

std::optional<ProgramBinary> Program::binary() const {
    GLint formats = 0;
    glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
    GLint length = 0;
    glGetProgramiv(name(), GL_PROGRAM_BINARY_LENGTH, &length);
    if (formats == 0 || length <= 0) {
        return std::nullopt;
    }
    ProgramBinary out;
    out.bytes.resize(static_cast<std::size_t>(length));
    GLsizei written = 0;
    glGetProgramBinary(name(), length, &written, &out.format, out.bytes.data());
    out.bytes.resize(static_cast<std::size_t>(written));
    return out;
}

void Program::bindBlock(const char* block, unsigned binding) const {
    const GLuint index = glGetUniformBlockIndex(name(), block);
    if (index != GL_INVALID_INDEX) {
        glUniformBlockBinding(name(), index, binding);
    }
}

void Program::bindSampler(const char* sampler, unsigned unit) const {
    if (const int location = uniform(sampler); location >= 0) {
        glProgramUniform1i(name(), location, static_cast<GLint>(unit));
    }
}

int Program::uniform(const char* uniformName) const {
    return glGetUniformLocation(name(), uniformName);
}

void Program::use() const {
    glUseProgram(name());
}

} // namespace patina::gl
