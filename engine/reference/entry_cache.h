// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "reference/glsl.h"

namespace patina::reference {

/// Keeps entries of a block's table, each with the N numbers that decided it, so that an entry near
/// which many cases look is worked out once. It is for one thread.
template <std::size_t N>
class EntryCache {
  public:
    /// Makes room for a table of `width` times `height` entries; of a large one only for some.
    EntryCache(int width, int height)
        : width_(width), height_(height),
          entries_(std::min(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                            maxEntries)) {}

    /// Returns the entry at x, 0 .. 1 along each axis, under the numbers: what `compute` returns.
    template <class Compute>
    vec3 at(vec2 x, const std::array<double, N>& numbers, const Compute& compute) {
        const double index = round(x.x * (width_ - 1)) + width_ * round(x.y * (height_ - 1));
        if (!(index >= 0.0)) {
            return compute(); // not a number
        }
        Entry& entry = entries_[static_cast<std::size_t>(index) % entries_.size()];
        if (!entry.isKnown || entry.x != x || entry.numbers != numbers) {
            entry = {.isKnown = true, .x = x, .numbers = numbers, .value = compute()};
        }
        return entry.value;
    }

  private:
    struct Entry {
        bool isKnown = false;
        vec2 x{0.0};
        std::array<double, N> numbers{};
        vec3 value{0.0};
    };
    static constexpr std::size_t maxEntries = 4096;

    int width_;
    int height_;
    std::vector<Entry> entries_;
};

} // namespace patina::reference
