// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/block_use.h"

#include <algorithm>

#include "shading/program/given_value.h"

namespace patina {
namespace {

std::string_view stateText(const Parameter& parameter, std::size_t state) {
    if (parameter.compiled == Compiled::WhenEqual) {
        return state == 0 ? "equal" : "unequal";
    }
    if (parameter.compiled == Compiled::WhenZero) {
        return state == 0 ? "zero" : "nonzero";
    }
    return infoOf(parameter.type).stateWord(parameter, state);
}

bool isCompiled(const Parameter& parameter) {
    return parameter.compiled != Compiled::No;
}

bool hasLevels(const AccuracyChoice& choice) {
    return !choice.values.empty();
}

} // namespace

BlockUse::BlockUse(const Block& block, const Values& values, const AccuracyLevels& levels)
    : block_(&block) {
    for (const Parameter& parameter : block.parameters) {
        if (isCompiled(parameter)) {
            states_.push_back(static_cast<std::uint16_t>(compiledState(block, parameter, values)));
        }
    }
    for (const AccuracyChoice& choice : block.accuracy) {
        if (hasLevels(choice)) {
            states_.push_back(static_cast<std::uint16_t>(chosenIndex(choice, levels)));
        }
    }
}

std::vector<CompiledValue> BlockUse::compiled() const {
    std::vector<CompiledValue> out;
    out.reserve(states_.size());
    for (const Parameter& parameter : block_->parameters) {
        if (isCompiled(parameter)) {
            out.push_back({parameter.id, stateText(parameter, states_[out.size()])});
        }
    }
    for (const AccuracyChoice& choice : block_->accuracy) {
        if (hasLevels(choice)) {
            out.push_back({choice.id, choice.values[states_[out.size()]].id});
        }
    }
    return out;
}

std::size_t BlockUse::placeOf(const Parameter& parameter) const {
    const auto end = std::ranges::find(block_->parameters, parameter.id, &Parameter::id);
    return static_cast<std::size_t>(std::count_if(block_->parameters.begin(), end, isCompiled));
}

std::size_t BlockUse::placeOf(const AccuracyChoice& choice) const {
    const auto end = std::ranges::find(block_->accuracy, choice.id, &AccuracyChoice::id);
    return static_cast<std::size_t>(std::ranges::count_if(block_->parameters, isCompiled) +
                                    std::count_if(block_->accuracy.begin(), end, hasLevels));
}

const EnumValue& BlockUse::level(const AccuracyChoice& choice) const {
    return choice.values[states_[placeOf(choice)]];
}

bool BlockUse::isEqual(const Parameter& parameter) const {
    return parameter.compiled == Compiled::WhenEqual && states_[placeOf(parameter)] == 0;
}

void BlockUse::setUnequal(const Parameter& parameter) {
    states_[placeOf(parameter)] = 1;
}

void BlockUse::setExact(const AccuracyChoice& choice) {
    states_[placeOf(choice)] = 0;
}

bool BlockUse::isBefore(const BlockUse& a, const BlockUse& b) {
    if (a.block_->id != b.block_->id) {
        return a.block_->id < b.block_->id;
    }
    std::size_t place = 0;
    for (const Parameter& parameter : a.block_->parameters) {
        if (!isCompiled(parameter)) {
            continue;
        }
        const std::string_view one = stateText(parameter, a.states_[place]);
        const std::string_view other = stateText(parameter, b.states_[place++]);
        if (one != other) {
            return one < other;
        }
    }
    for (const AccuracyChoice& choice : a.block_->accuracy) {
        if (!hasLevels(choice)) {
            continue;
        }
        const std::string& one = choice.values[a.states_[place]].id;
        const std::string& other = choice.values[b.states_[place++]].id;
        if (one != other) {
            return one < other;
        }
    }
    return false;
}

} // namespace patina
