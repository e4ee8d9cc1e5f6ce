// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace patina {

/// Holds a value of a type that is any number of numbers: a curve's points, a ramp's stops.
struct NumberList {
    std::string_view type; ///< is the type's word, which lives as long as the program
    std::vector<double> numbers{};

    friend bool operator==(const NumberList&, const NumberList&) = default;
};

/// Is the value of one parameter. Which alternative is held follows from the parameter's type:
/// bool; int; double for float and angle (an angle is in degrees everywhere but in the shader);
/// dvec2; dvec3 for vec3 and color (linear Rec. 709); string for enum (the chosen value's id) and
/// texture (a file); a list of numbers for curve and ramp. Documents round numbers to float when
/// they are set; only `patina eval` keeps all 53 bits.
using Value = std::variant<bool, int, double, glm::dvec2, glm::dvec3, std::string, NumberList>;

/// Maps the id of a parameter to its value.
using Values = std::map<std::string, Value, std::less<>>;

/// Returns the same value with every number rounded to the nearest float.
Value roundedToFloat(const Value& value);

/// Tells whether every number in the value is finite.
bool isFinite(const Value& value);

} // namespace patina
