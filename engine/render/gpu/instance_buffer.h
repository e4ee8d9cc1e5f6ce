// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "gl/buffer.h"
#include "gl/driver.h"
#include "render/gpu/instance.h"

namespace patina {

/// Holds the transforms of objects in the GPU's memory and writes only what changed.
class InstanceBuffer {
  public:
    /// Begins new content; add() appends to it and upload() sends it.
    void clear() { staged_.clear(); }
    void add(const Instance& instance) { staged_.push_back(instance); }
    std::size_t size() const { return staged_.size(); }

    /// Sends what differs from the last upload and returns true if anything did.
    bool upload();

    /// Returns the buffer, which is the same one for the life of this object.
    const std::shared_ptr<const gl::Buffer>& buffer() const { return shared_; }

    /// Returns gl::hasBaseInstances() of the context in which the buffer was made.
    bool hasBase() const { return hasBase_; }

  private:
    void makeRoom();

    std::shared_ptr<gl::Buffer> buffer_ = std::make_shared<gl::Buffer>(gl::Buffer::create());
    std::shared_ptr<const gl::Buffer> shared_ = buffer_;
    bool hasBase_ = gl::hasBaseInstances();
    std::vector<Instance> staged_;
    std::vector<Instance> sent_; ///< is as long as the buffer's room
    std::size_t sentCount_ = 0;
};

/// Holds the transform of one object in a buffer of its own.
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
