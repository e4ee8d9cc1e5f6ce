// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>

#include "catalog/descriptor.h"

namespace patina {

using ShaderNames = std::set<std::string, std::less<>>;

/// Returns the names that Patina's own GLSL below a folder of shaders uses, and a block must not:
/// what the files of lib/ declare, and every word of passes/, where the blocks' functions are
/// called.
ShaderNames shaderNames(const std::filesystem::path& shaders);

/// Returns what is wrong with the id of a block: its struct and functions must not have one of
/// these names or that of a function of GLSL.
Errors nameMistakes(const Descriptor& descriptor, const ShaderNames& taken);

} // namespace patina
