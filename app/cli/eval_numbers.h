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

/// Reads a direction, which may have any length but 0, into `target`. Very long and very short ones
/// are scaled by a power of two into the range of floats.
Result<void> readDirection(const nlohmann::json& json, const std::string& key, glm::dvec3& target);

} // namespace patina
