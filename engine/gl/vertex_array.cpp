// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/vertex_array.h"

#include <epoxy/gl.h>

namespace patina::gl {

void deleteVertexArray(unsigned name) {
    glDeleteVertexArrays(1, &name);
}

VertexArray VertexArray::create() {
    VertexArray array;
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    array.name_ = Name<deleteVertexArray>(name);
    return array;
}

void VertexArray::bind() const {
    glBindVertexArray(name());
}

void VertexArray::attribute(unsigned location, const Buffer& buffer, int components,
                            std::size_t stride, std::size_t offset) {
    bind();
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));
}

void VertexArray::shorts(unsigned location, const Buffer& buffer) {
    bind();
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, 4, GL_SHORT, GL_FALSE, 4 * sizeof(GLshort), nullptr);
}

void VertexArray::shares(unsigned location, const Buffer& buffer) {
    bind();
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, 4, GL_UNSIGNED_SHORT, GL_TRUE, 4 * sizeof(GLushort), nullptr);
}

void VertexArray::instanced(unsigned location, const Buffer& buffer, unsigned count,
                            std::size_t offset, unsigned copies) const {
    constexpr std::size_t size = 4 * sizeof(float);
    bind();
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    for (unsigned i = 0; i < count; ++i) {
        glEnableVertexAttribArray(location + i);
        glVertexAttribDivisor(location + i, copies);
        glVertexAttribPointer(location + i, 4, GL_FLOAT, GL_FALSE,
                              static_cast<GLsizei>(count * size),
                              reinterpret_cast<const void*>(offset + i * size)); // NOLINT: as above
    }
}

} // namespace patina::gl
