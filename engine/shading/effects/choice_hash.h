// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/fnv_hash.h"
#include "shading/program/block_use.h"

namespace patina {

/// Hashes choices, without any allocation.
class ChoiceHash {
  public:
    void add(std::string_view text) {
        for (const char c : text) {
            addByte(static_cast<unsigned char>(c));
        }
        addByte(0);
    }

    void add(std::uint64_t number) {
        for (int shift = 0; shift < 64; shift += 8) {
            addByte(static_cast<unsigned char>(number >> shift));
        }
    }

    void add(bool truth) { addByte(truth ? 1 : 0); }

    void add(const BlockUse& use) {
        add(std::string_view(use.block().kind));
        add(std::string_view(use.block().id));
        for (const std::uint16_t state : use.states()) {
            addByte(static_cast<unsigned char>(state));
            addByte(static_cast<unsigned char>(state >> 8));
        }
    }

    void add(const std::optional<BlockUse>& use) {
        add(use.has_value());
        if (use) {
            add(*use);
        }
    }

    std::uint64_t value() const { return hash_.value(); }

  private:
    void addByte(unsigned char byte) { hash_.add(byte); }

    FnvHash hash_;
};

} // namespace patina
