// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace patina {

/// Returns 16 hexadecimal digits that other contents hardly have: FNV-1a of 64 bits (G. Fowler, L.
/// C. Noll, K.-P. Vo, The FNV Non-Cryptographic Hash Algorithm), the same on every machine.
std::string contentHash(std::string_view bytes);

} // namespace patina
