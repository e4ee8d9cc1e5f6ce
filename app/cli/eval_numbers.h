// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "core/error.h"

namespace patina {

/// Returns what a key of a line of `patina eval` holds; the error says what is missing or wrong.
Result<double> number(const nlohmann::json& json, const std::string& key);
Result<glm::dvec3> vector(const nlohmann::json& json, const std::string& key);

/// A vector that says a direction: any but one without length. Very long and very short ones are
/// scaled, in all digits, to what a float holds.
Result<void> readDirection(const nlohmann::json& json, const std::string& key, glm::dvec3& target);

} // namespace patina
