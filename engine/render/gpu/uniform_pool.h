// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "gl/buffer.h"

namespace patina {

/// Keeps many uniform blocks of vec4s in one buffer. What did not change is not written to the
/// GPU again.
class UniformPool {
  public:
    /// Represents a block's place, which holds until the next clear().
    struct Place {
        std::size_t first = 0;
        std::size_t vec4s = 0;
    };

    /// The next blocks are placed from the start again; equal ones in an equal order are found
    /// where they were.
    void clear() { used_ = 0; }
    Place add(std::size_t vec4s);

    /// Memory for all blocks that were added; before staging() and upload().
    void makeRoom();

    /// Returns where a block's content is put together.
    std::span<glm::vec4> staging(const Place& place);

    /// Sends the block if it differs from what was sent; true if so.
    bool upload(const Place& place);

    void bind(unsigned bindingPoint, const Place& place) const;

  private:
    gl::Buffer buffer_ = gl::Buffer::create();
    std::vector<glm::vec4> staged_;
    std::vector<glm::vec4> sent_;
    std::size_t used_ = 0;
};

} // namespace patina
