// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace patina {

/// Holds some of a scene's lights, by their numbers.
class LightSet {
  public:
    /// Keeps its memory.
    void clear() { words_.clear(); }

    void add(std::size_t light) {
        if (light / bits >= words_.size()) {
            words_.resize(light / bits + 1, 0);
        }
        words_[light / bits] |= std::uint64_t(1) << (light % bits);
    }

    bool has(std::size_t light) const {
        return light / bits < words_.size() && ((words_[light / bits] >> (light % bits)) & 1) != 0;
    }

    bool empty() const { return words_.empty(); }

    friend bool operator==(const LightSet&, const LightSet&) = default;

  private:
    static constexpr std::size_t bits = 64;

    std::vector<std::uint64_t> words_; ///< the last one is not 0
};

} // namespace patina
