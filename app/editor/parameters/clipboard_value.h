// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "catalog/parameter.h"

namespace patina {

/// Returns a value as text for the clipboard: "0.5", "true", "ggx", "[0.8, 0.1, 0.1]".
std::string copiedText(const Value& value);

/// Returns what pasted text means to a parameter, kept in its hard range; a colour may be sRGB hex
/// too. Returns nothing when the text is no such value.
std::optional<Value> pastedValue(const Parameter& parameter, std::string_view text);

} // namespace patina
