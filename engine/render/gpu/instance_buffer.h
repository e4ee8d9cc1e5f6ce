// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "gl/buffer.h"
#include "gl/driver.h"
#include "render/gpu/instance.h"

namespace patina {

/// Holds where objects are, in the GPU's memory; only what changed is written there.
class InstanceBuffer {
  public:
    /// The next content is put together anew.
    void clear() { staged_.clear(); }
    void add(const Instance& instance) { staged_.push_back(instance); }
    std::size_t size() const { return staged_.size(); }

    /// Sends what differs from what was sent; true if something did.
    bool upload();

    /// Stays the same; it has room for what was sent.
    const std::shared_ptr<const gl::Buffer>& buffer() const { return shared_; }

    /// See gl::hasBaseInstances().
    bool hasBase() const { return hasBase_; }

  private:
    void makeRoom();

    std::shared_ptr<gl::Buffer> buffer_ = std::make_shared<gl::Buffer>(gl::Buffer::create());
    std::shared_ptr<const gl::Buffer> shared_ = buffer_;
    bool hasBase_ = gl::hasBaseInstances();
    std::vector<Instance> staged_;
    std::vector<Instance> sent_; ///< as many as the buffer has room for
    std::size_t sentCount_ = 0;
};

/// Holds one object alone.
class SingleInstance {
  public:
    bool place(const glm::dmat4& world) {
        buffer_.clear();
        buffer_.add(instanceAt(world));
        return buffer_.upload();
    }
    const InstanceBuffer& buffer() const { return buffer_; }

  private:
    InstanceBuffer buffer_;
};

} // namespace patina
