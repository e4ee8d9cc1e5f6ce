// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace patina {

/// Hashes bytes by FNV-1a with 64 bits, the same on every machine: G. Fowler, L. C. Noll, K.-P. Vo,
/// D. Eastlake, The FNV Non-Cryptographic Hash Algorithm. Allocates nothing.
class FnvHash {
  public:
    void add(unsigned char byte) { value_ = (value_ ^ byte) * 0x100000001b3u; }

    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325u;
};

/// Returns the hash of a content as 16 hexadecimal digits, which other contents hardly have.
std::string contentHash(std::string_view bytes);

} // namespace patina
