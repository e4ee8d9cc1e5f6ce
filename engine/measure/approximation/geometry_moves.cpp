// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/geometry_moves.h"

#include <optional>

#include <fmt/format.h>

namespace patina {
namespace {

using NodeKind = ShaderExpression::Kind;

/// Says what a number of the geometry is, from others of it: {0} is the struct.
struct GeometryForm {
    std::string_view structure;
    std::string_view number;
    std::string_view form;
    std::string_view words;
};

// shaders/lib/directions.glsl says how the exact ones are computed.
constexpr GeometryForm geometryForms[] = {
    {"Directions", "rv", "min(2.0 * {0}.nl * {0}.nv - {0}.lv, 1.0)",
     "r.v as 2 (n.l)(n.v) - l.v, as it is rounded"},
    {"Directions", "versineRv", "max(1.0 - {0}.rv, 0.0)", "1 - r.v from the rounded cosine"},
    {"Directions", "versineRv", "max(1.0 - (2.0 * {0}.nl * {0}.nv - {0}.lv), 0.0)",
     "1 - r.v as 1 - 2 (n.l)(n.v) + l.v, as it is rounded"},
    {"Directions", "versineLh", "max(1.0 - {0}.lh, 0.0)", "1 - l.h from the rounded cosine"},
    {"Directions", "versineL", "1.0 - {0}.nl", "1 - n.l from the rounded cosine"},
    {"Directions", "vercosineL", "1.0 + {0}.nl", "1 + n.l from the rounded cosine"},
    {"Directions", "sin2l", "max(1.0 - {0}.nl * {0}.nl, 0.0)",
     "the squared sine of n and l from the rounded cosine"},
    {"Directions", "sin2v", "max(1.0 - {0}.nv * {0}.nv, 0.0)",
     "the squared sine of n and v from the rounded cosine"},
    {"Directions", "sin2h", "max({0}.HH - {0}.cos2h, 0.0)",
     "the squared sine of n and h from the rounded cosine"},
    {"Directions", "lv", "0.5 * {0}.HH - 1.0", "l.v from |l + v|^2, as it is rounded"},
    {"Incidence", "versine", "1.0 - {0}.c", "1 - cos of the incidence from the rounded cosine"},
};

/// Returns the text of the struct whose number an expression reads; nothing where it reads another.
std::optional<std::string_view> ownerOf(const ObservedShader& shader, int index,
                                        std::string_view structure, std::string_view number) {
    const ShaderExpression& expression = shader.at(index);
    if (expression.kind != NodeKind::Field || expression.sign != number) {
        return std::nullopt;
    }
    const ShaderExpression& owner = shader.at(expression.operands.front());
    const int type = owner.type.structure;
    const std::string_view text = shader.syntax.textOf(owner);
    const bool isIt = owner.kind == NodeKind::Local && type >= 0 && !text.empty() &&
                      shader.syntax.structs[static_cast<std::size_t>(type)].name == structure;
    return isIt ? std::optional(text) : std::nullopt;
}

/// Returns the struct of which an expression is |l + v|^2, also as the sum of the squared sine and
/// cosine of n and h on its scale.
std::optional<std::string_view> wholeOf(const ObservedShader& shader, int index) {
    if (const auto owner = ownerOf(shader, index, "Directions", "HH")) {
        return owner;
    }
    const ShaderExpression& expression = shader.at(index);
    if (expression.kind != NodeKind::Binary || expression.sign != "+") {
        return std::nullopt;
    }
    for (const std::size_t first : {0u, 1u}) {
        const auto sine = ownerOf(shader, expression.operands[first], "Directions", "sin2h");
        const auto cosine = ownerOf(shader, expression.operands[1 - first], "Directions", "cos2h");
        if (sine && sine == cosine) {
            return sine;
        }
    }
    return std::nullopt;
}

ShaderEdit editOf(const ShaderExpression& expression, const std::string& form) {
    return {expression.first, expression.last, '(' + form + ')', {}, expression.owner};
}

void addIfAny(std::vector<CheapMove>& moves, CheapMove move) {
    if (!move.edits.empty()) {
        move.gainsBeside = true;
        moves.push_back(std::move(move));
    }
}

CheapMove formMove(const ObservedShader& shader, const std::vector<int>& changeable,
                   const GeometryForm& form) {
    CheapMove move{{}, std::string(form.words)};
    for (const int index : changeable) {
        if (const auto owner = ownerOf(shader, index, form.structure, form.number)) {
            move.edits.push_back(
                editOf(shader.at(index), fmt::format(fmt::runtime(form.form), *owner)));
        }
    }
    return move;
}

/// Makes one number of the sum of the squared sine and cosine.
CheapMove wholeMove(const ObservedShader& shader, const std::vector<int>& changeable) {
    CheapMove move{{}, "|l + v|^2 for the sum of the squared sine and cosine of n and h"};
    for (const int index : changeable) {
        const auto owner = wholeOf(shader, index);
        if (owner && shader.at(index).kind == NodeKind::Binary) {
            move.edits.push_back(editOf(shader.at(index), fmt::format("{}.HH", *owner)));
        }
    }
    return move;
}

/// Takes the squared sine and cosine of n and h, over their sum, from n.h.
CheapMove shareMove(const ObservedShader& shader, const std::vector<int>& changeable) {
    CheapMove move{{}, "sin^2 and cos^2 of n and h from the rounded n.h, without a division"};
    for (const int index : changeable) {
        const ShaderExpression& expression = shader.at(index);
        if (expression.kind != NodeKind::Binary || expression.sign != "/") {
            continue;
        }
        const auto whole = wholeOf(shader, expression.operands[1]);
        const auto sine = ownerOf(shader, expression.operands[0], "Directions", "sin2h");
        const auto cosine = ownerOf(shader, expression.operands[0], "Directions", "cos2h");
        if (whole && sine == whole) {
            move.edits.push_back(
                editOf(expression, fmt::format("max(1.0 - {0}.nh * {0}.nh, 0.0)", *whole)));
        } else if (whole && cosine == whole) {
            move.edits.push_back(editOf(expression, fmt::format("{0}.nh * {0}.nh", *whole)));
        }
    }
    return move;
}

} // namespace

std::vector<CheapMove> geometryMoves(const ObservedShader& shader) {
    const std::vector<int> changeable = changeableExpressions(shader);
    std::vector<CheapMove> moves;
    for (const GeometryForm& form : geometryForms) {
        addIfAny(moves, formMove(shader, changeable, form));
    }
    addIfAny(moves, wholeMove(shader, changeable));
    addIfAny(moves, shareMove(shader, changeable));
    return moves;
}

} // namespace patina
