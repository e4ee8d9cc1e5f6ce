// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace patina {

/// Describes one field of the struct that blocks are a function of, under the key that a line of
/// `patina eval` uses; or the number that they are a function of.
struct ArgumentField {
    enum class Type {
        Direction, ///< unit
        Normal,    ///< unit; made to be on the side of the direction before it
        Color,     ///< 0 or more
        Number,    ///< 0 .. `max`
        Amount,    ///< 0 or more
        Whole,     ///< 0 .. `max`
        Flag
    };

    std::string_view key;
    Type type = Type::Number;
    double max = 1.0;
    /// Is the default of each of its numbers. When it is absent, a line must give them.
    std::optional<double> usual{};
    std::string_view member{}; ///< names the struct's member; empty: `key` does

    constexpr std::string_view memberName() const { return member.empty() ? key : member; }
    constexpr std::size_t numbers() const { return isTriple() ? 3 : 1; }
    constexpr bool isTriple() const { return isDirection() || type == Type::Color; }
    constexpr bool isDirection() const { return type == Type::Direction || type == Type::Normal; }
    constexpr bool isContinuous() const { return type != Type::Whole && type != Type::Flag; }
};

/// Counts the numbers of all fields together.
constexpr std::size_t numbersOf(std::span<const ArgumentField> fields) {
    std::size_t numbers = 0;
    for (const ArgumentField& field : fields) {
        numbers += field.numbers();
    }
    return numbers;
}

} // namespace patina
