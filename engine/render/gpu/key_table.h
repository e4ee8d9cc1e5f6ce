// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace patina {

/// Maps keys to numbers. It keeps its memory, so that filling it again allocates nothing.
class KeyTable {
  public:
    /// Forgets all keys and makes room for `maxKeys` new ones, which must not be exceeded.
    void clear(std::size_t maxKeys) {
        const std::size_t places = std::bit_ceil(2 * maxKeys + 2);
        if (places > places_.size() || ++round_ == 0) {
            places_.assign(std::max(places, places_.size()), Place());
            round_ = 1;
        }
    }

    /// Returns the key's number; a new key gets `next`.
    std::size_t find(std::uint64_t key, std::size_t next) {
        const std::size_t mask = places_.size() - 1;
        std::size_t at = (key * 0x9e3779b97f4a7c15u >> 32) & mask;
        while (places_[at].round == round_ && places_[at].key != key) {
            at = (at + 1) & mask;
        }
        if (places_[at].round != round_) {
            places_[at] = {key, static_cast<std::uint32_t>(next), round_};
        }
        return places_[at].number;
    }

  private:
    struct Place {
        std::uint64_t key = 0;
        std::uint32_t number = 0;
        std::uint32_t round = 0; ///< must be round_, else this place is free
    };

    std::vector<Place> places_;
    std::uint32_t round_ = 0;
};

} // namespace patina
