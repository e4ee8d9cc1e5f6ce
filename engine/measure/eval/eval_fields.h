// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace patina {

/// One field of a struct that a block is a function of, as a line of `patina eval` names it.
struct EvalField {
    enum class Type {
        Direction, ///< unit
        Normal,    ///< unit, on the side of the direction before it
        Color,     ///< 0 or more
        Number,    ///< 0 .. `most`
        Whole,     ///< 0 .. `most`
        Flag
    };

    std::string_view key;
    Type type = Type::Number;
    double max = 1.0;
    std::optional<double>
        usual{}; ///< each of its numbers, where a line says nothing; absent: it must

    std::size_t numbers() const { return isTriple() ? 3 : 1; }
    bool isTriple() const { return isDirection() || type == Type::Color; }
    bool isDirection() const { return type == Type::Direction || type == Type::Normal; }
    bool isContinuous() const { return type != Type::Whole && type != Type::Flag; }
};

/// The numbers of all fields of a struct, one after the other.
using FieldNumbers = std::array<double, 8>;

/// The fields of a struct of shaders/lib by its GLSL name, in the order in which it declares them;
/// none where it cannot be said in a line.
std::span<const EvalField> evalFieldsOf(std::string_view type);

/// Returns how many numbers they are.
std::size_t numbersOf(std::span<const EvalField> fields);

} // namespace patina
