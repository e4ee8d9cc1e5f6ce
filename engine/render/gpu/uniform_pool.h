// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "gl/buffer.h"

namespace patina {

/// Owns many uniform blocks of vec4s in one buffer. A block that did not change is not written to
/// the GPU again.
class UniformPool {
  public:
    /// Is a block's place in the buffer, in vec4s; it is valid until the next clear().
    struct Place {
        std::size_t first = 0;
        std::size_t vec4s = 0;
    };

    /// Places the next blocks from the start again. Blocks of the same sizes in the same order get
    /// their old places, so that equal content is not sent again.
    void clear() { used_ = 0; }
    Place add(std::size_t vec4s);

    /// Makes room for all blocks that were added. It must be called before staging() and upload().
    void makeRoom();

    /// Returns the memory for a block's content; it still holds the last one.
    std::span<glm::vec4> staging(const Place& place);

    /// Sends the block and returns true if it differs from what was sent.
    bool upload(const Place& place);

    void bind(unsigned bindingPoint, const Place& place) const;

  private:
    gl::Buffer buffer_ = gl::Buffer::create();
    std::vector<glm::vec4> staged_;
    std::vector<glm::vec4> sent_;
    std::size_t used_ = 0;
};

} // namespace patina
