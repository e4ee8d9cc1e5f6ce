// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/eval_numbers.h"

#include <algorithm>
#include <cmath>

namespace patina {

namespace {

using Json = nlohmann::json;

/// Scales a direction of any length to one whose square floats can hold, by a power of two so that
/// no digit changes.
glm::dvec3 ofUsualLength(const glm::dvec3& v) {
    const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    constexpr double usual = 0x1p30;
    if (size >= 1.0 / usual && size <= usual) {
        return v;
    }
    const int exponent = -std::ilogb(size);
    return {std::scalbn(v.x, exponent), std::scalbn(v.y, exponent), std::scalbn(v.z, exponent)};
}

} // namespace

Result<double> number(const Json& json, const std::string& key) {
    if (!json.contains(key)) {
        return failure("there is no \"" + key + "\"", "a number");
    }
    if (!json[key].is_number()) {
        return failure(key + " is not a number", "a number");
    }
    return json[key].get<double>();
}

Result<glm::dvec3> vector(const Json& json, const std::string& key) {
    if (!json.contains(key)) {
        return failure("there is no \"" + key + "\"", "an array of 3 numbers");
    }
    const Json& value = json[key];
    const bool right = value.is_array() && value.size() == 3 &&
                       std::all_of(value.begin(), value.end(),
                                   [](const Json& element) { return element.is_number(); });
    if (!right) {
        return failure(key + " is not a vector", "an array of 3 numbers");
    }
    return glm::dvec3(value[0].get<double>(), value[1].get<double>(), value[2].get<double>());
}

Result<void> readDirection(const Json& json, const std::string& key, glm::dvec3& target) {
    const Result<glm::dvec3> value = vector(json, key);
    if (!value) {
        return tl::unexpected(value.error());
    }
    if (*value == glm::dvec3(0.0)) {
        return failure(key + " has no length", "a direction");
    }
    target = ofUsualLength(*value);
    return {};
}

} // namespace patina
