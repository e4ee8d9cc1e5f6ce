// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/error.h"

namespace patina {

/// Returns the name of a preset's file in a folder of what was made of presets: that of the preset
/// with another suffix, as "gold.png".
std::string nameInFolder(const std::string& preset, std::string_view suffix);

/// Makes a folder where there is none; fails where two presets would have a file of the same name
/// there, which is called `what` in the message.
Result<void> prepareFolder(const std::string& folder, std::span<const std::string> presets,
                           std::string_view suffix, std::string_view what);

/// Tells whether an output is a folder: there is one of that name, or it ends with "/".
bool isFolder(const std::string& output);

} // namespace patina
