// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "catalog/parameter.h"

namespace patina {

/// Is the role of a parameter whose function reads the table with the grain of its file.
inline constexpr std::string_view grainRole = "grain";

/// Returns the number of the table that the function of a parameter of type `measured` reads, by
/// tableNumber(); 0 for no file.
int tableOfFile(const Parameter& parameter, const std::string& file);

} // namespace patina
