// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/buffer.h"

#include <cassert>

#include <epoxy/gl.h>

namespace patina::gl {

void deleteBuffer(unsigned name) {
    glDeleteBuffers(1, &name);
}

Buffer Buffer::create() {
    Buffer buffer;
    GLuint name = 0;
    glGenBuffers(1, &name);
    buffer.name_ = Name<deleteBuffer>(name);
    return buffer;
}

void Buffer::fill(unsigned target, std::span<const std::byte> bytes) {
    glBindBuffer(target, name());
    glBufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
    size_ = bytes.size();
}

void Buffer::reserve(unsigned target, std::size_t size, Content content) {
    glBindBuffer(target, name());
    glBufferData(target, static_cast<GLsizeiptr>(size), nullptr,
                 content == Content::Lasting ? GL_STATIC_DRAW : GL_DYNAMIC_DRAW);
    size_ = size;
}

void Buffer::write(unsigned target, std::span<const std::byte> bytes, std::size_t offset) {
    assert(offset + bytes.size() <= size_);
    glBindBuffer(target, name());
    glBufferSubData(target, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()),
                    bytes.data());
}

} // namespace patina::gl
