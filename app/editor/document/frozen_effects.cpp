// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/frozen_effects.h"

#include <algorithm>
#include <array>
#include <utility>

#include "shading/effects/effect_key.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

/// Returns a value of the parameter's type with this number in every component.
Value filled(const Parameter& parameter, double number) {
    const double inside = std::clamp(number, parameter.min, parameter.max);
    const Value& type = parameter.defaultValue;
    if (std::holds_alternative<double>(type)) {
        return inside;
    }
    if (std::holds_alternative<int>(type)) {
        return static_cast<int>(std::clamp(inside, -1e9, 1e9));
    }
    if (std::holds_alternative<glm::dvec2>(type)) {
        return glm::dvec2(inside);
    }
    if (std::holds_alternative<glm::dvec3>(type)) {
        return glm::dvec3(inside);
    }
    return type;
}

/// Values never count as nothing in the inside of their range, except at 0.
Value inside(const Parameter& parameter) {
    const auto between = [&parameter](double share) {
        return parameter.softMin + share * (parameter.softMax - parameter.softMin);
    };
    return filled(parameter, between(0.5) != 0.0 ? between(0.5) : between(0.75));
}

bool isCompared(const NeutralValue& value, const Parameter& one, const Parameter& other) {
    return (value.id == one.id && value.word == other.id) ||
           (value.id == other.id && value.word == one.id);
}

/// Tells whether the program, or what says when the block does nothing, compares the two.
bool areCompared(const Block& block, const Parameter& one, const Parameter& other) {
    return one.equalTo == other.id || other.equalTo == one.id ||
           std::ranges::any_of(block.neutral, [&](const NeutralCase& neutral) {
               return std::ranges::any_of(neutral, [&](const NeutralValue& value) {
                   return isCompared(value, one, other);
               });
           });
}

/// Returns the value that the parameter has where it is the same as this one.
Value equalTo(const Parameter& parameter, const Value& other) {
    const auto* number = std::get_if<double>(&other);
    const auto* triple = std::get_if<glm::dvec3>(&other);
    const bool isNumber = std::holds_alternative<double>(parameter.defaultValue);
    return number     ? filled(parameter, *number)
           : !triple  ? parameter.defaultValue
           : isNumber ? filled(parameter, triple->x)
                      : other;
}

/// Returns values at which a program may lose an effect: the ends of the slider, 0, and every value
/// that this one is compared with.
std::vector<Value> edgesOf(const DocumentState& state, const BlockPath& path,
                           const Parameter& parameter, const Catalog& catalog) {
    std::vector<Value> edges{filled(parameter, 0.0), filled(parameter, parameter.softMin),
                             filled(parameter, parameter.softMax)};
    const BlockValues* held = blockValuesAt(state, path);
    const Block* block = held ? catalog.find(path.kind, held->id) : nullptr;
    for (const Parameter& other : block ? block->parameters : std::vector<Parameter>()) {
        if (areCompared(*block, parameter, other)) {
            edges.push_back(equalTo(parameter, givenValue(other, held->parameters)));
        }
    }
    return edges;
}

/// Returns a value where the effect is there: none of the edges.
Value apart(const Parameter& parameter, const std::vector<Value>& edges) {
    const Value usual = inside(parameter);
    const bool isEdge = std::find(edges.begin(), edges.end(), usual) != edges.end();
    return isEdge ? filled(parameter, 0.3 * parameter.softMin + 0.7 * parameter.softMax) : usual;
}

/// Holds the keys of the programs for the objects and the ground, and of the one behind them.
using Keys = std::array<std::uint64_t, 4>;

Keys keysOf(const DocumentState& state, const BlockPath& path, const Catalog& catalog) {
    if (path.isOfView) {
        Scene shown = state.scene;
        giveOwn(shown, ownView(state, path.side));
        return {EffectKey().ofScene(shown, catalog), 0, isSeen(shown.ground) ? 1u : 0u,
                EffectKey::ofDisplay(shown, catalog)};
    }
    const Material* material = materialAt(state, path.index, path.side);
    return {EffectKey().ofScene(state.scene, catalog),
            material != nullptr ? EffectKey::ofMaterial(*material, catalog) : 0,
            isSeen(state.scene.ground) ? 1u : 0u, EffectKey::ofDisplay(state.scene, catalog)};
}

/// Returns what a drag of the parameter may come by, as far as it makes other programs.
std::vector<Value> reachedValues(const Parameter& parameter) {
    const ParameterTypeInfo& info = infoOf(parameter.type);
    if (info.function != nullptr) {
        return info.states == nullptr ? std::vector<Value>() : info.states(parameter);
    }
    return {inside(parameter), filled(parameter, 0.0), filled(parameter, parameter.softMin),
            filled(parameter, parameter.softMax)};
}

} // namespace

std::vector<DocumentState> prewarmed(const DocumentState& state, const BlockPath& path,
                                     const Parameter& parameter, const Catalog& catalog) {
    if (!infoOf(parameter.type).hasRange) {
        return {};
    }
    std::vector<DocumentState> states;
    if (dependsOnPlaces(state.scene, catalog, path.kind)) {
        states.push_back(state); // with what is out because of its place
    }
    std::vector<Keys> known{keysOf(state, path, catalog)};
    for (const Value& value : reachedValues(parameter)) {
        DocumentState changed = state;
        storeValue(changed, path, parameter.id, value);
        const Keys keys = keysOf(changed, path, catalog);
        if (std::find(known.begin(), known.end(), keys) == known.end()) {
            known.push_back(keys);
            states.push_back(std::move(changed));
        }
    }
    return states;
}

void FrozenEffects::begin(const DocumentState& state, int object, const BlockPath& path,
                          const Parameter& parameter, const Catalog& catalog) {
    Held held{state, {}, object, path, parameter.id};
    const auto keysWith = [&](const Value& value) {
        storeValue(held.state, path, parameter.id, value);
        return keysOf(held.state, path, catalog);
    };
    const std::vector<Value> edges = edgesOf(state, path, parameter, catalog);
    const Keys effective = keysWith(apart(parameter, edges));
    const bool decides = dependsOnPlaces(state.scene, catalog, path.kind) ||
                         std::any_of(edges.begin(), edges.end(), [&](const Value& value) {
                             return keysWith(value) != effective;
                         });
    held_.reset();
    if (decides) {
        storeValue(held.state, path, parameter.id, apart(parameter, edges));
        held_ = std::move(held);
        showSides();
    }
}

void FrozenEffects::keepTexture(const DocumentState& state, int object, const BlockPath& path,
                                const std::string& key) {
    if (!held_) {
        held_ = Held{state, {}, object, path, {}};
    }
    Material* material = materialAt(held_->state, path.index, path.side);
    const auto use = material->textures.find(key);
    if (use != material->textures.end()) {
        use->second.strength = 1.0;
    }
    showSides();
}

void FrozenEffects::follow(const DocumentState& state, const BlockPath& path,
                           std::string_view parameterId) {
    if (!held_ || (path == held_->path && parameterId == held_->parameterId)) {
        return;
    }
    if (const std::optional<Value> value = storedValue(state, path, parameterId)) {
        storeValue(held_->state, path, parameterId, *value);
        showSides();
    }
}

bool FrozenEffects::differs(const DocumentState& state, const Catalog& catalog) const {
    return held_ &&
           keysOf(held_->state, held_->path, catalog) != keysOf(state, held_->path, catalog);
}

const Scene* FrozenEffects::scene(Side side) const {
    if (!held_) {
        return nullptr;
    }
    const std::optional<Scene>& shown = held_->shown[indexOf(side)];
    return shown ? &*shown : &held_->state.scene;
}

void FrozenEffects::showSides() {
    const DocumentState& state = held_->state;
    for (const Side side : sides) {
        const bool differs = indexOf(side) < shownSides(state) && held_->object >= 0 &&
                             (side != Side::A || overlaidPicture(state, side) != nullptr);
        held_->shown[indexOf(side)] =
            differs ? std::optional(shownScene(state, held_->object, side)) : std::nullopt;
    }
}

} // namespace patina
