// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/value.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/vectors.h"

namespace patina {

Value roundedToFloat(const Value& value) {
    return std::visit(
        [](const auto& held) -> Value {
            using Held = std::decay_t<decltype(held)>;
            if constexpr (std::is_same_v<Held, double>) {
                return static_cast<double>(static_cast<float>(held));
            } else if constexpr (std::is_same_v<Held, glm::dvec2>) {
                return glm::dvec2(glm::vec2(held));
            } else if constexpr (std::is_same_v<Held, glm::dvec3>) {
                return glm::dvec3(glm::vec3(held));
            } else if constexpr (std::is_same_v<Held, NumberList>) {
                NumberList rounded = held;
                for (double& number : rounded.numbers) {
                    number = static_cast<double>(static_cast<float>(number));
                }
                return rounded;
            } else {
                return held;
            }
        },
        value);
}

bool isFinite(const Value& value) {
    if (const auto* number = std::get_if<double>(&value)) {
        return std::isfinite(*number);
    }
    if (const auto* pair = std::get_if<glm::dvec2>(&value)) {
        return std::isfinite(pair->x) && std::isfinite(pair->y);
    }
    if (const auto* triple = std::get_if<glm::dvec3>(&value)) {
        return isFinite(*triple);
    }
    if (const auto* list = std::get_if<NumberList>(&value)) {
        return std::ranges::all_of(list->numbers, [](double x) { return std::isfinite(x); });
    }
    return true;
}

} // namespace patina
