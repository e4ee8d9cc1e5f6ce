// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/uniform_buffer.h"

#include <algorithm>
#include <cstring>

#include <epoxy/gl.h>

namespace patina {

void UniformBuffer::reserve(std::size_t vec4s) {
    if (vec4s > staged_.size()) {
        staged_.resize(vec4s, glm::vec4(0.0f));
        sent_.resize(vec4s, glm::vec4(0.0f));
        buffer_.reserve(GL_UNIFORM_BUFFER, vec4s * sizeof(glm::vec4));
        sentCount_ = 0;
    }
}

bool UniformBuffer::upload(std::size_t vec4s) {
    const std::size_t bytes = vec4s * sizeof(glm::vec4);
    if (vec4s <= sentCount_ && std::memcmp(staged_.data(), sent_.data(), bytes) == 0) {
        return false;
    }
    buffer_.write(GL_UNIFORM_BUFFER, std::as_bytes(std::span(staged_).first(vec4s)));
    std::memcpy(sent_.data(), staged_.data(), bytes);
    sentCount_ = std::max(sentCount_, vec4s);
    return true;
}

void UniformBuffer::bind(unsigned bindingPoint) const {
    glBindBufferBase(GL_UNIFORM_BUFFER, bindingPoint, buffer_.name());
}

} // namespace patina
