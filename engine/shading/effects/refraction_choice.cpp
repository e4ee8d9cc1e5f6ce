// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/refraction_choice.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "shading/effects/effect_choice.h"
#include "shading/effects/texture_choice.h"

namespace patina {
namespace {

constexpr std::string_view kind = kinds::refraction;

std::optional<double> numberIn(const Block& block, const Values& values, std::string_view id) {
    const Parameter* parameter = block.parameter(id);
    const auto* number =
        parameter == nullptr ? nullptr : std::get_if<double>(&givenValue(*parameter, values));
    return number == nullptr ? std::nullopt : std::optional(*number);
}

/// The index of a dielectric that reflects so much of what meets it straight.
double indexOf(const glm::dvec3& f0) {
    const double mean = std::clamp((f0.x + f0.y + f0.z) / 3.0, 0.0, 0.66);
    return (1.0 + std::sqrt(mean)) / (1.0 - std::sqrt(mean));
}

std::optional<double> fresnelIndex(const Block& block, const Values& values) {
    const auto outside = numberIn(block, values, "index.outside");
    const auto inside = numberIn(block, values, "index.inside");
    if (outside && inside) {
        return *inside / std::max(*outside, 1e-6);
    }
    const Parameter* f0 = block.parameter("f0");
    const auto* color = f0 == nullptr ? nullptr : std::get_if<glm::dvec3>(&givenValue(*f0, values));
    return color == nullptr ? std::nullopt : std::optional(indexOf(*color));
}

/// The index that the material has by what else it is made of.
std::optional<double> surfaceIndex(const Material& material, const Catalog& catalog) {
    const BlockValues* part = material.part(kinds::fresnel);
    const Block* fresnel = part == nullptr ? nullptr : catalog.find(kinds::fresnel, part->id);
    if (fresnel != nullptr) {
        if (const auto index = fresnelIndex(*fresnel, part->parameters)) {
            return index;
        }
    }
    const Block* model = catalog.find(kinds::models, material.model.id);
    return model == nullptr ? std::nullopt : numberIn(*model, material.model.parameters, "index");
}

bool isOwn(const Block& block, const Values& values) {
    const Parameter* from = block.parameter("index.from");
    const auto* word =
        from == nullptr ? nullptr : std::get_if<std::string>(&givenValue(*from, values));
    return word == nullptr || *word == "own";
}

bool isWhite(const Block& block, const Values& values, std::string_view id) {
    const Parameter* parameter = block.parameter(id);
    return parameter == nullptr || givenValue(*parameter, values) == Value(glm::dvec3(1.0));
}

bool isNeutral(const Material& material, const RefractionChoice& choice, const Catalog& catalog) {
    return isWhite(*choice.block, *choice.values, "tint") &&
           isWhite(*choice.block, *choice.values, "absorption.color") &&
           bodyIndex(material, choice, catalog) == 1.0;
}

} // namespace

RefractionChoice refractionChoice(const Material& material, const Catalog& catalog) {
    const BlockValues* part = material.part(kind);
    if (part == nullptr) {
        return {};
    }
    const RefractionChoice choice{catalog.find(kind, part->id), &part->parameters, ""};
    if (choice.block == nullptr) {
        return {nullptr, nullptr, "No refraction of this kind is known."};
    }
    if (!isTransparent(material, catalog)) {
        return {nullptr, nullptr, "The material's opacity is 1: nothing passes."};
    }
    if (isNeutral(material, choice, catalog)) {
        return {nullptr, nullptr, "Its index is 1 and it colours nothing."};
    }
    return choice;
}

double bodyIndex(const Material& material, const RefractionChoice& choice, const Catalog& catalog) {
    std::optional<double> index;
    if (!isOwn(*choice.block, *choice.values)) {
        index = surfaceIndex(material, catalog);
    }
    if (!index) {
        index = numberIn(*choice.block, *choice.values, "index");
    }
    const double given = index.value_or(1.0);
    return std::isfinite(given) ? std::clamp(given, 0.1, 10.0) : 1.0;
}

bool isSheet(const Block& refraction) {
    return refraction.parameter("thickness") != nullptr;
}

bool hasRefraction(const Scene& scene, const Catalog& catalog) {
    return std::ranges::any_of(scene.objects, [&catalog](const Object& object) {
        return object.visible && canBeSeen(object.material) &&
               refractionChoice(object.material, catalog).block != nullptr;
    });
}

bool showsSceneRefracted(const Scene& scene, const Catalog& catalog) {
    if (!hasRefraction(scene, catalog)) {
        return false;
    }
    const auto isDrawn = [](const Object& object) {
        return object.visible && canBeSeen(object.material);
    };
    return isSeen(scene.ground) || std::ranges::count_if(scene.objects, isDrawn) > 1;
}

} // namespace patina
