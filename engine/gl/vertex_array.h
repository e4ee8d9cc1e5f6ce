// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "gl/buffer.h"
#include "gl/name.h"

namespace patina::gl {

void deleteVertexArray(unsigned name);

/// Owns a vertex array object, which says how vertices lie in buffers.
class VertexArray {
  public:
    static VertexArray create();

    void bind() const;

    /// Reads an attribute of `components` floats from `buffer`; `stride` and `offset` are in bytes.
    /// Leaves the vertex array bound.
    void attribute(unsigned location, const Buffer& buffer, int components, std::size_t stride,
                   std::size_t offset);

    /// Reads four 16-bit integers per vertex as floats of the same value. Leaves the vertex array
    /// bound.
    void shorts(unsigned location, const Buffer& buffer);

    /// Reads four 16-bit integers per vertex as floats, 65535 as 1. Leaves the vertex array bound.
    void shares(unsigned location, const Buffer& buffer);

    /// Reads `count` attributes of four floats each into the locations from `location` on. They lie
    /// one behind the other in `buffer` from `offset` bytes on and advance once per `copies`
    /// instances. Leaves the vertex array bound.
    void instanced(unsigned location, const Buffer& buffer, unsigned count, std::size_t offset,
                   unsigned copies = 1) const;

    unsigned name() const { return name_.get(); }

  private:
    Name<deleteVertexArray> name_;
};

} // namespace patina::gl
