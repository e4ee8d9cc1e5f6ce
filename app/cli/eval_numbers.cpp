// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/eval_numbers.h"

#include <algorithm>

namespace patina {

using Json = nlohmann::json;

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
    target = *value;
    return {};
}

} // namespace patina
