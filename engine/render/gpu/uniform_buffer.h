// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "gl/buffer.h"

namespace patina {

/// Owns a uniform block of vec4s, which is written to the GPU only when its content changed.
class UniformBuffer {
  public:
    /// Makes room for at least `vec4s`; the block never shrinks.
    void reserve(std::size_t vec4s);

    /// Returns the memory for the next content; it still holds the last one.
    std::span<glm::vec4> staging() { return staged_; }

    /// Sends the first `vec4s` of the staging area and returns true if they differ from what was
    /// sent.
    bool upload(std::size_t vec4s);

    void bind(unsigned bindingPoint) const;

  private:
    gl::Buffer buffer_ = gl::Buffer::create();
    std::vector<glm::vec4> staged_;
    std::vector<glm::vec4> sent_;
    std::size_t sentCount_ = 0;
};

} // namespace patina
