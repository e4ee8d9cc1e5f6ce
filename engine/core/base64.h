// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace patina {

/// Returns bytes in base64 (RFC 4648), as data URIs have them.
std::string base64(std::string_view bytes);

} // namespace patina
