// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/eval/eval_fields.h"

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

} // namespace

std::span<const EvalField> evalFieldsOf(std::string_view type) {
    constexpr std::pair<std::string_view, std::span<const EvalField>> structs[] = {
        {"Outlook", outlook}, {"Crossing", crossing}, {"Edge", edge}, {"Layer", layer}};
    for (const auto& [name, fields] : structs) {
        if (name == type) {
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
