// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <span>

namespace patina {

/// Holds the points of a curve, or the stops of a ramp, without allocating memory.
template <class Item, std::size_t capacity>
class SpacedList {
  public:
    std::span<const Item> span() const { return {items_.data(), size_}; }
    std::size_t size() const { return size_; }
    void add(const Item& item) { items_[size_++] = item; }

    /// Sorts by `place`, then drops each item that is nearer than `gap` to the one before it.
    /// Places may be nearer by as much as rounding to floats moves them.
    void space(double Item::*place, double gap) {
        const auto end = items_.begin() + static_cast<std::ptrdiff_t>(size_);
        std::sort(items_.begin(), end,
                  [place](const Item& a, const Item& b) { return a.*place < b.*place; });
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            if (kept == 0 || !isTooNear(items_[kept - 1].*place, items_[i].*place, gap)) {
                items_[kept++] = items_[i];
            }
        }
        size_ = kept;
    }

    static bool isTooNear(double before, double after, double gap) {
        constexpr double rounding = 1e-6;
        return after - before < gap - rounding;
    }

  private:
    std::array<Item, capacity> items_{};
    std::size_t size_ = 0;
};

} // namespace patina
