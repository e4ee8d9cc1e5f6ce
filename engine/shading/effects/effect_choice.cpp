// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/effect_choice.h"

#include <algorithm>
#include <span>

#include <glm/common.hpp>

#include "scene/environment.h"
#include "shading/effects/fog_depth.h"
#include "shading/effects/neutral_values.h"
#include "shading/effects/refraction_choice.h"
#include "shading/effects/texture_choice.h"

namespace patina {
namespace {

/// The least that a model is taken to keep of the light: below half of an 8-bit step.
constexpr double minKept = 1.0 / 1024.0;

/// The mesh whose parts all lie in one plane.
constexpr std::string_view flatMesh = "builtin:plane";

/// What hides at least so much casts shadows.
constexpr double minShadowing = 0.5;

} // namespace

bool notPositive(const Value& value) {
    if (const auto* number = std::get_if<double>(&value)) {
        return !(*number > 0.0);
    }
    if (const auto* whole = std::get_if<int>(&value)) {
        return *whole <= 0;
    }
    if (const auto* triple = std::get_if<glm::dvec3>(&value)) {
        return !(triple->x > 0.0 || triple->y > 0.0 || triple->z > 0.0);
    }
    return false;
}

const Value& givenValue(const Parameter& parameter, const Values& values) {
    const auto found = values.find(parameter.id);
    const bool usable =
        found != values.end() && found->second.index() == parameter.defaultValue.index();
    return usable ? found->second : parameter.defaultValue;
}

std::size_t chosenIndex(const Parameter& parameter, const Values& values) {
    const auto* given = std::get_if<std::string>(&givenValue(parameter, values));
    const auto* usual = std::get_if<std::string>(&parameter.defaultValue);
    const bool known = given != nullptr &&
                       std::any_of(parameter.values.begin(), parameter.values.end(),
                                   [given](const EnumValue& value) { return value.id == *given; });
    const std::string* chosen = known ? given : usual;
    return chosen == nullptr ? 0 : indexOf(parameter.values, *chosen);
}

std::size_t chosenIndex(const AccuracyChoice& choice, const AccuracyLevels& levels) {
    const auto found = levels.find(choice.id);
    return found == levels.end() ? 0 : indexOf(choice.values, found->second);
}

bool isZero(const Parameter& parameter, const Values& values) {
    const Value& value = givenValue(parameter, values);
    const auto* number = std::get_if<double>(&value);
    return number != nullptr && *number == 0.0;
}

std::size_t compiledState(const Block& block, const Parameter& parameter, const Values& values) {
    if (parameter.compiled == Compiled::WhenZero) {
        return isZero(parameter, values) ? 0 : 1;
    }
    if (parameter.compiled == Compiled::WhenEqual) {
        const Parameter* other = block.parameter(parameter.equalTo);
        return other != nullptr && givenValue(parameter, values) == givenValue(*other, values) ? 0
                                                                                               : 1;
    }
    return infoOf(parameter.type).state(parameter, givenValue(parameter, values));
}

bool canShine(const Light& light, const Block& block) {
    return light.enabled && !isNeutral(block, light.block.parameters);
}

bool canHide(const Scene& scene, const Block& block, const EffectView& view) {
    return !isNeutral(block, scene.part(kinds::fog)->parameters) &&
           maxChange(scene, block, view) >= halfStep;
}

bool hasAmbient(const Scene& scene) {
    return scene.ambient.x > 0.0 || scene.ambient.y > 0.0 || scene.ambient.z > 0.0;
}

double saidShare(const Material& material, const Catalog& catalog) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    double kept = 1.0;
    for (const Parameter& parameter :
         model ? std::span(model->parameters) : std::span<const Parameter>()) {
        const double* share =
            parameter.transparency
                ? std::get_if<double>(&givenValue(parameter, material.model.parameters))
                : nullptr;
        if (share != nullptr && *share > 0.0) {
            kept *= 1.0 - std::min(*share, 1.0);
        }
    }
    return 1.0 - kept;
}

double passedShare(const Material& material, const Catalog& catalog) {
    return std::min(saidShare(material, catalog), 1.0 - minKept);
}

double opacityOf(const Material& material, const Catalog& catalog) {
    return material.opacity * (1.0 - passedShare(material, catalog));
}

bool canShadow(const Material& material, const Catalog& catalog) {
    return material.opacity >= minShadowing && opacityOf(material, catalog) >= minShadowing;
}

bool isCaster(const Object& object, const Catalog& catalog) {
    return object.visible && object.castsShadow && canShadow(object.material, catalog);
}

bool hasCaster(const Scene& scene, const Catalog& catalog) {
    return std::ranges::any_of(
        scene.objects, [&catalog](const Object& object) { return isCaster(object, catalog); });
}

bool hasReceiver(const Scene& scene, const Catalog& catalog) {
    return isSeen(scene.ground) ||
           std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
               return object.visible && canBeSeen(object.material) &&
                      catalog.find(kinds::models, object.material.model.id) != nullptr;
           });
}

bool isLoneFlat(const Scene& scene, const Catalog& catalog) {
    const Object* lone = nullptr;
    for (const Object& object : scene.objects) {
        if (!object.visible || !(canBeSeen(object.material) || isCaster(object, catalog))) {
            continue;
        }
        if (lone != nullptr) {
            return false;
        }
        lone = &object;
    }
    return lone != nullptr && lone->mesh == flatMesh && !isSeen(scene.ground);
}

bool hasShadows(const Scene& scene, const Catalog& catalog) {
    return hasCaster(scene, catalog) && hasReceiver(scene, catalog) && !isLoneFlat(scene, catalog);
}

const Block* shadowBlock(const Light& light, const Block& block, const Catalog& catalog) {
    const bool casts = light.shadow && block.shadowProjection != ShadowProjection::None;
    return casts ? catalog.find(kinds::shadows, light.shadow->id) : nullptr;
}

bool isVisiblyTransparent(const Object& object, const Catalog& catalog) {
    return object.visible && canBeSeen(object.material) && isTransparent(object.material, catalog);
}

int countTransparent(const Scene& scene, const Catalog& catalog) {
    return static_cast<int>(std::ranges::count_if(scene.objects, [&catalog](const Object& object) {
        return isVisiblyTransparent(object, catalog);
    }));
}

const Block* transparencyBlock(const Scene& scene, const Catalog& catalog) {
    const bool isNeeded = scene.part(kinds::transparency) &&
                          std::ranges::any_of(scene.objects, [&catalog](const Object& object) {
                              return isVisiblyTransparent(object, catalog);
                          });
    return isNeeded ? catalog.find(kinds::transparency, scene.part(kinds::transparency)->id)
                    : nullptr;
}

bool hasHemisphere(const Scene& scene) {
    return !notPositive(scene.hemisphere.sky) || !notPositive(scene.hemisphere.ground);
}

EnvironmentChoice environmentChoice(const Scene& scene, const Catalog& catalog) {
    if (!scene.part(kinds::environment)) {
        return {};
    }
    const Block* block = catalog.find(kinds::environment, scene.part(kinds::environment)->id);
    if (block == nullptr) {
        return {nullptr, "No environment of this kind is known."};
    }
    if (isNeutral(*block, scene.part(kinds::environment)->parameters) &&
        !hasRefraction(scene, catalog)) {
        return {nullptr, "It is dark."};
    }
    if (pictureParameter(*block) != nullptr &&
        pictureFile(*scene.part(kinds::environment), *block).empty()) {
        return {nullptr, "No picture is chosen for it."};
    }
    return {block, ""};
}

bool hasFresnelSlot(const Block& model) {
    return model.slot(kinds::fresnel) != nullptr;
}

SlotChoice slotChoice(const Slot& slot, const Material& material, const Catalog& catalog) {
    static const Values none;
    const BlockValues* part = material.part(slot.kind);
    const Block* chosen = part == nullptr ? nullptr : catalog.find(slot.kind, part->id);
    if (chosen != nullptr) {
        return {chosen, &part->parameters, true};
    }
    return {slot.defaultBlock.empty() ? nullptr : catalog.find(slot.kind, slot.defaultBlock), &none,
            false};
}

bool isNeutral(const SlotChoice& choice, const Material& material) {
    return choice.block != nullptr && isNeutralPart(*choice.block, *choice.values, material);
}

OutlineChoice outlineChoice(const Material& material, const Catalog& catalog) {
    const BlockValues* part = material.part(kinds::outline);
    if (part == nullptr) {
        return {};
    }
    const Block* block = catalog.find(kinds::outline, part->id);
    if (block == nullptr) {
        return {nullptr, "No outline of this kind is known."};
    }
    bool hasWidths = false;
    for (const Parameter& parameter : block->parameters) {
        const bool isWidth = parameter.id == "width" || parameter.id.ends_with(".width");
        if (isWidth && !notPositive(givenValue(parameter, part->parameters))) {
            return {block, ""};
        }
        hasWidths = hasWidths || isWidth;
    }
    return hasWidths ? OutlineChoice{nullptr, "Its lines are 0 pixels wide."}
                     : OutlineChoice{block, ""};
}

bool isEmitted(const Parameter& parameter, const Values& values) {
    return parameter.emission && !notPositive(givenValue(parameter, values));
}

} // namespace patina
