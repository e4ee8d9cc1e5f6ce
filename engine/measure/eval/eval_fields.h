// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "catalog/block_kind.h"

namespace patina {

/// One field of a struct that a block is a function of, as a line of `patina eval` names it; or the
/// number that it is a function of.
struct EvalField {
    enum class Type {
        Direction, ///< unit
        Normal,    ///< unit, on the side of the direction before it
        Color,     ///< 0 or more
        Number,    ///< 0 .. `most`
        Amount,    ///< 0 or more
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

/// The fields of the struct of shaders/lib that a function takes, in the order in which it declares
/// them, or the one number that it takes, 0 or more, by its name; none where it takes nothing, or
/// what cannot be said by fields.
std::span<const EvalField> evalFieldsOf(const BlockFunction& function);

/// Returns how many numbers they are.
std::size_t numbersOf(std::span<const EvalField> fields);

} // namespace patina
