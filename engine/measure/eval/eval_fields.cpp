// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/eval/eval_fields.h"

#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace patina {
namespace {

using Type = EvalField::Type;

constexpr EvalField outlook[] = {{.key = "direction", .type = Type::Direction},
                                 {.key = "picture", .type = Type::Color, .usual = 1.0}};
constexpr EvalField crossing[] = {{.key = "l", .type = Type::Direction},
                                  {.key = "n", .type = Type::Normal},
                                  {.key = "channel", .type = Type::Whole, .max = 2, .usual = 1},
                                  {.key = "leaves", .type = Type::Flag, .usual = 0}};
constexpr EvalField edge[] = {{.key = "turns", .type = Type::Flag, .usual = 0},
                              {.key = "ends", .type = Type::Flag, .usual = 0},
                              {.key = "bend", .max = std::numbers::pi, .usual = 0}};
constexpr EvalField layer[] = {{.key = "depth"}, {.key = "opacity"}};

using NumberFields = std::map<std::string_view, EvalField>;

/// The numbers that functions of the kinds take, by name.
NumberFields numberFields() {
    NumberFields fields;
    for (const BlockKind& kind : blockKinds()) {
        for (const BlockFunction& function : kind.functions) {
            if (function.argument == "float") {
                fields.try_emplace(function.name, EvalField{function.name, Type::Amount});
            }
        }
    }
    return fields;
}

} // namespace

std::span<const EvalField> evalFieldsOf(const BlockFunction& function) {
    static const NumberFields numbers = numberFields();
    if (function.argument == "float") {
        return {&numbers.at(function.name), 1};
    }
    constexpr std::pair<std::string_view, std::span<const EvalField>> structs[] = {
        {"Outlook", outlook}, {"Crossing", crossing}, {"Edge", edge}, {"Layer", layer}};
    for (const auto& [name, fields] : structs) {
        if (name == function.argument) {
            return fields;
        }
    }
    return {};
}

std::size_t numbersOf(std::span<const EvalField> fields) {
    return std::accumulate(
        fields.begin(), fields.end(), std::size_t{0},
        [](std::size_t sum, const EvalField& field) { return sum + field.numbers(); });
}

} // namespace patina
