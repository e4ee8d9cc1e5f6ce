// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace patina::tests {

/// Feeds bytes to everything that reads JSON: the parser, presets and the schemas. It ends the
/// program when what was read changes by being written and read again.
void readAsFiles(std::string_view bytes);

} // namespace patina::tests
