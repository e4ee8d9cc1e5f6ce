// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace patina {

/// Returns the path of another program of Patina's: beside this program, as in a build folder, or
/// where it is installed.
std::filesystem::path siblingProgram(const std::string& name);

} // namespace patina
