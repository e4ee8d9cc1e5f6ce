// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "gl/name.h"

namespace patina::gl {

void deleteBuffer(unsigned name);

/// Owns a buffer object.
class Buffer {
  public:
    static Buffer create();

    /// Replaces the content and the size; the driver is told that the content rarely changes.
    /// `target` is a GL buffer target; the buffer stays bound to it.
    void fill(unsigned target, std::span<const std::byte> bytes);

    enum class Content { Lasting, Changing };

    /// Allocates `size` bytes, whose content is undefined, and leaves the buffer bound to `target`.
    /// `content` tells the driver how often they will be written.
    void reserve(unsigned target, std::size_t size, Content content = Content::Changing);

    /// Overwrites bytes from `offset` on, which must lie within size(). The buffer stays bound to
    /// `target`.
    void write(unsigned target, std::span<const std::byte> bytes, std::size_t offset = 0);

    unsigned name() const { return name_.get(); }
    std::size_t size() const { return size_; }

  private:
    Name<deleteBuffer> name_;
    std::size_t size_ = 0;
};

} // namespace patina::gl
