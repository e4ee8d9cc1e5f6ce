// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/uniform_pool.h"

#include <algorithm>
#include <cstring>

#include <epoxy/gl.h>

namespace patina {
namespace {

/// Is a number of vec4s; no driver asks for blocks to begin at multiples of more than 256 bytes.
constexpr std::size_t alignment = 256 / sizeof(glm::vec4);
constexpr std::size_t firstRoom = 16 * alignment;

} // namespace

UniformPool::Place UniformPool::add(std::size_t vec4s) {
    const Place place{used_, vec4s};
    used_ += (vec4s + alignment - 1) / alignment * alignment;
    return place;
}

void UniformPool::makeRoom() {
    if (used_ <= staged_.size()) {
        return;
    }
    const std::size_t room = std::max({used_, 2 * staged_.size(), firstRoom});
    staged_.assign(room, glm::vec4(0.0f));
    sent_ = staged_;
    buffer_.reserve(GL_UNIFORM_BUFFER, room * sizeof(glm::vec4));
    buffer_.write(GL_UNIFORM_BUFFER, std::as_bytes(std::span(sent_)));
}

std::span<glm::vec4> UniformPool::staging(const Place& place) {
    return std::span(staged_).subspan(place.first, place.vec4s);
}

bool UniformPool::upload(const Place& place) {
    const std::span<const glm::vec4> staged = staging(place);
    glm::vec4* sent = sent_.data() + place.first;
    if (std::memcmp(staged.data(), sent, staged.size_bytes()) == 0) {
        return false;
    }
    buffer_.write(GL_UNIFORM_BUFFER, std::as_bytes(staged), place.first * sizeof(glm::vec4));
    std::copy(staged.begin(), staged.end(), sent);
    return true;
}

void UniformPool::bind(unsigned bindingPoint, const Place& place) const {
    glBindBufferRange(GL_UNIFORM_BUFFER, bindingPoint, buffer_.name(),
                      static_cast<GLintptr>(place.first * sizeof(glm::vec4)),
                      static_cast<GLsizeiptr>(place.vec4s * sizeof(glm::vec4)));
}

} // namespace patina
