// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace patina {

/// Returns an ordinary file of that name in one of PATH's folders, of the first that has it; empty
/// where none has.
std::filesystem::path programInPath(const std::string& name);

} // namespace patina
