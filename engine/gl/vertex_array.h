// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "gl/buffer.h"
#include "gl/name.h"

namespace patina::gl {

void deleteVertexArray(unsigned name);

/// Tells how vertices lie in buffers.
class VertexArray {
  public:
    static VertexArray create();

    void bind() const;

    /// A float attribute of `components` read from `buffer`; leaves the vertex array bound.
    void attribute(unsigned location, const Buffer& buffer, int components, std::size_t stride,
                   std::size_t offset);

    /// Feeds four 16-bit whole numbers as floats of the same value; leaves the vertex array bound.
    void shorts(unsigned location, const Buffer& buffer);

    /// `count` attributes of four floats from `location` on, one behind the other in `buffer`, that
    /// advance once per instance; leaves the vertex array bound.
    void instanced(unsigned location, const Buffer& buffer, unsigned count,
                   std::size_t offset) const;

    unsigned name() const { return name_.get(); }

  private:
    Name<deleteVertexArray> name_;
};

} // namespace patina::gl
