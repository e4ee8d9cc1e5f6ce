// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

namespace patina::gl {

/// Owns the name of one GL object and deletes the object with itself. It can only be moved, and
/// must be destroyed while the object's context is current. 0 means that it owns nothing.
template <void (*destroy)(unsigned)>
class Name {
  public:
    Name() = default;
    explicit Name(unsigned name) : name_(name) {}
    Name(Name&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Name& operator=(Name&& other) noexcept {
        if (this != &other) {
            reset();
            name_ = std::exchange(other.name_, 0);
        }
        return *this;
    }
    Name(const Name&) = delete;
    Name& operator=(const Name&) = delete;
    ~Name() { reset(); }

    unsigned get() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

  private:
    void reset() {
        if (name_ != 0) {
            destroy(name_);
            name_ = 0;
        }
    }

    unsigned name_ = 0;
};

} // namespace patina::gl
