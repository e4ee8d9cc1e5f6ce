// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "core/error.h"
#include "core/value.h"

namespace patina {

/// Says why JSON holds no value of a parameter. Like every Error of a value it has no place in a
/// file.
struct ValueError : Error {
    ValueError(Error error, std::string inside = {})
        : Error(std::move(error)), within(std::move(inside)) {}

    std::string within; ///< is the JSON pointer from the value to the mistake; may be empty
};

/// Holds a value as JSON has it, or why there is none.
using ValueReading = tl::expected<Value, ValueError>;

/// Is short for a ValueError at a place within a value.
inline tl::unexpected<ValueError> failureWithin(std::string pointer, std::string problem,
                                                std::string expected) {
    return tl::unexpected(
        ValueError({{}, 0, 0, std::move(problem), std::move(expected)}, std::move(pointer)));
}

/// Names one of the parts that a value is made of: a point, a stop.
struct ValuePart {
    std::string name;    ///< is a name such as "point 3"; empty: it is the whole value
    std::string pointer; ///< is the JSON pointer from the value to the part
};

} // namespace patina
