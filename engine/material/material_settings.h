// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "material/material.h"

namespace patina {

/// Returns the value of a setting that every material has; nothing where there is none of this id.
std::optional<Value> settingOf(const Material& material, std::string_view id);

/// Stores such a value. Does nothing where the id is not known or the value has the wrong type.
void storeSetting(Material& material, std::string_view id, const Value& value);

} // namespace patina
