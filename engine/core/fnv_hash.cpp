// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fnv_hash.h"

#include <fmt/format.h>

namespace patina {

std::string contentHash(std::string_view bytes) {
    FnvHash hash;
    for (const char byte : bytes) {
        hash.add(static_cast<unsigned char>(byte));
    }
    return fmt::format("{:016x}", hash.value());
}

} // namespace patina
