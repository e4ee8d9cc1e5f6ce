// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/block_use.h"

#include <utility>

#include "shading/effects/effect_choice.h"

namespace patina {
namespace {

std::string stateText(const Block& block, const Parameter& parameter, const Values& values) {
    const std::size_t state = compiledState(block, parameter, values);
    if (parameter.compiled == Compiled::WhenEqual) {
        return state == 0 ? "equal" : "unequal";
    }
    if (parameter.compiled == Compiled::WhenZero) {
        return state == 0 ? "zero" : "nonzero";
    }
    return infoOf(parameter.type).stateWord(parameter, state);
}

std::vector<CompiledValue> compiledValues(const Block& block, const Values& values,
                                          const AccuracyLevels& levels) {
    std::vector<CompiledValue> out;
    for (const Parameter& parameter : block.parameters) {
        if (parameter.compiled != Compiled::No) {
            out.push_back({parameter.id, stateText(block, parameter, values)});
        }
    }
    for (const AccuracyChoice& choice : block.accuracy) {
        if (!choice.values.empty()) {
            out.push_back({choice.id, choice.values[chosenIndex(choice, levels)].id});
        }
    }
    return out;
}

} // namespace

BlockUse useOf(const Block& block, const Values& values, const AccuracyLevels& levels,
               std::string reason) {
    return {block.kind, block.id, compiledValues(block, values, levels), std::move(reason)};
}

} // namespace patina
