// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/data_packer.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

#include "catalog/fills.h"
#include "catalog/index_trend.h"
#include "catalog/spectrum.h"
#include "shading/effects/effect_key.h"
#include "shading/effects/key_light.h"
#include "shading/effects/light_colors.h"
#include "shading/effects/lights.h"
#include "shading/effects/opacity.h"
#include "shading/effects/shadows.h"
#include "shading/program/given_value.h"
#include "shading/program/parameter_packer.h"
#include "shading/program/storable.h"

namespace patina {
namespace {

const AccuracyLevels exact;

void packShadow(std::span<glm::vec4> out, const BlockPlace& place, const Light& light,
                const ShadowView& view, const glm::dmat4& cameraToWorld) {
    static const Values none;
    const auto first = static_cast<std::size_t>(place.first);
    const auto size = static_cast<std::size_t>(place.vec4s());
    const BlockValues* shadow = light.part(kinds::shadows);
    packInto(out.subspan(first, size), place.layout, shadow != nullptr ? shadow->parameters : none,
             exact, cameraToWorld);
    packView(out.subspan(first + size, ShadowLayout::vec4s), view);
}

void packLight(std::span<glm::vec4> out, const LightPlace& place, const SceneToPack& packing,
               std::size_t index, const glm::dmat4& cameraToWorld) {
    static const ShadowView nowhere;
    const Light& light = packing.scene.lights[index];
    packInto(out, place.light.layout, light.block.parameters, exact, cameraToWorld);
    if (place.shadow) {
        packShadow(out, *place.shadow, light,
                   index < packing.shadows.size() ? packing.shadows[index] : nowhere,
                   cameraToWorld);
    }
    if (place.colors > 0) {
        const LightColors colors = lightColors(*place.light.block, light.block.parameters);
        const auto first = static_cast<std::size_t>(place.colors);
        out[first] = storable(colors.diffuse);
        out[first + 1] = storable(colors.highlight);
        out[first + 2] = storable(colors.ambient);
        const LightPolarisation field =
            lightPolarisation(*place.light.block, light.block.parameters);
        out[first + 3] = glm::vec4(glm::vec3(field.direction), field.degree);
    }
}

/// Returns the key light. While a value is dragged it stays one for which the programs have code.
std::optional<std::size_t> keyLightOf(const SceneToPack& packing, const Pipeline& pipeline) {
    const Catalog& catalog = *pipeline.catalog;
    const std::optional<std::size_t> key = keyLight(packing.scene, catalog);
    const bool shadows = hasShadows(packing.effects, catalog);
    const bool isKnown =
        key && lightKey(packing.effects.lights[*key], catalog, shadows) == pipeline.effects.keyKind;
    return isKnown ? key : keyLight(packing.effects, catalog);
}

/// Writes the lights of a group and its header: their count, their place, and that of the key
/// light, if it is among them. A group that is unrolled in the program's text must have all its
/// lights, so those that do not reach the object are written as zeros.
void packGroup(PackedScene& packed, std::span<glm::vec4> out, const Pipeline& pipeline,
               std::size_t index, const SceneToPack& packing,
               const std::optional<std::size_t>& keyLight, const glm::dmat4& cameraToWorld) {
    const bool shadows = hasShadows(packing.effects, *pipeline.catalog);
    std::size_t keyPlace = 0;
    const LightPlace& group = pipeline.scene.groups[index];
    const LightGroup& effect = pipeline.effects.lights[index];
    const std::uint64_t key = effect.key();
    const auto size = static_cast<std::size_t>(group.vec4s());
    const std::size_t start = packed.vec4s;
    int count = 0;
    for (std::size_t i = 0; i < packing.scene.lights.size(); ++i) {
        if ((effect.lines == 0 && !packing.has(i)) ||
            EffectKey::ofLight(packing.effects.lights[i], *pipeline.catalog, shadows) != key) {
            continue;
        }
        if (packed.vec4s + size > out.size()) {
            ++packed.lostLights;
            continue;
        }
        const std::span<glm::vec4> place = out.subspan(packed.vec4s, size);
        if (packing.has(i)) {
            keyPlace = i == keyLight ? packed.vec4s : keyPlace;
            packLight(place, group, packing, i, cameraToWorld);
        } else {
            std::ranges::fill(place, glm::vec4(0.0f));
        }
        packed.vec4s += size;
        ++count;
    }
    out[static_cast<std::size_t>(group.light.first)] = glm::vec4(count, start, keyPlace, 0.0f);
}

/// Writes unrolled groups first, because the program reads them at fixed places without their
/// count.
void packLights(PackedScene& packed, std::span<glm::vec4> out, const Pipeline& pipeline,
                const SceneToPack& packing, const glm::dmat4& cameraToWorld) {
    const std::vector<LightGroup>& groups = pipeline.effects.lights;
    const std::optional<std::size_t> key = keyLightOf(packing, pipeline);
    for (const bool inLines : {true, false}) {
        for (std::size_t g = 0; g < pipeline.scene.groups.size(); ++g) {
            if ((groups[g].lines > 0) == inLines) {
                packGroup(packed, out, pipeline, g, packing, key, cameraToWorld);
            }
        }
    }
}

/// Writes the spectra of a choice, at wavelengths in nm, in the place of what it sets.
void packSpectra(std::span<glm::vec4> out, const ParameterLayout& layout, const EnumValue& choice,
                 const glm::dvec3& wavelengths) {
    for (const ParameterField& field : layout.fields) {
        const auto fill = field.parameter == nullptr ? choice.fills.end()
                                                     : choice.fills.find(field.parameter->id);
        const NumberList* spectrum =
            fill == choice.fills.end() ? nullptr : spectrumIn(fill->second);
        if (spectrum == nullptr) {
            continue;
        }
        const glm::dvec3 numbers = atWavelengths(*spectrum, wavelengths);
        for (int channel = 0; channel < 3; ++channel) {
            const std::size_t at = field.offset + static_cast<std::size_t>(channel);
            out[at / 4][static_cast<int>(at % 4)] = static_cast<float>(numbers[channel]);
        }
    }
}

/// Puts the index at the temperature of the block in the place of that which was measured.
void packTemperature(std::span<glm::vec4> out, const BlockPlace& place, const Values& values) {
    if (const ParameterField* field = place.layout.withRole(roles::indexInside)) {
        double number = 0.0;
        writeNumbers(*field->parameter, givenValue(*field->parameter, values), &number);
        takeTemperature(*place.block, *field->parameter, values, &number);
        out[field->offset / 4][static_cast<int>(field->offset % 4)] = static_cast<float>(number);
    }
}

/// Tells whether a length keeps its size on the screen. Strokes have widths in other units.
bool isOnScreen(const Block& block, const Parameter& parameter) {
    return parameter.role == roles::screenLength ||
           (block.kind == kinds::outline && parameter.role == roles::width);
}

/// Multiplies such lengths by the device pixel ratio. The shader has them in pixels, so that edges
/// stay one pixel wide.
void packScreenLengths(std::span<glm::vec4> out, const BlockPlace& place, double pixelRatio) {
    for (const ParameterField& field : place.layout.fields) {
        if (field.parameter != nullptr && isOnScreen(*place.block, *field.parameter)) {
            out[field.offset / 4][static_cast<int>(field.offset % 4)] *=
                static_cast<float>(pixelRatio);
        }
    }
}

void packPlace(std::span<glm::vec4> out, const BlockPlace& place, const Values& values,
               const AccuracyLevels& levels, const PackedAround& around) {
    const std::span<glm::vec4> own = out.subspan(static_cast<std::size_t>(place.first));
    packInto(own, place.layout, values, levels, around);
    packTemperature(own, place, values);
    packScreenLengths(own, place, around.pixelRatio);
    if (around.wavelengths == srgbWavelengths) {
        return; // of which documents hold the numbers
    }
    for (const Parameter& parameter : place.block->parameters) {
        if (const EnumValue* choice = spectralChoice(parameter, values)) {
            packSpectra(own, place.layout, *choice, around.wavelengths);
        }
    }
}

/// Packs the data of effects that have a function for it.
template <class Owner>
void packOwn(std::span<glm::vec4> out, const OwnData<Owner>& data, const Owner& owner,
             const EffectSet& set) {
    for (const auto& place : data.own) {
        place.pack(out.subspan(static_cast<std::size_t>(place.first),
                               static_cast<std::size_t>(place.vec4s)),
                   owner, set);
    }
}

/// Returns the values for a part: those of its owner when the owner has the same block, else none.
const Values& partValues(const BlockPlace& place, const BlockParts& parts) {
    static const Values none;
    const BlockValues* part = partOf(parts, place.block->kind);
    return part != nullptr && part->id == place.block->id ? part->parameters : none;
}

} // namespace

PackedScene packScene(std::span<glm::vec4> out, const Pipeline& pipeline,
                      const SceneToPack& packing, const glm::dmat4& cameraToWorld) {
    const Scene& scene = packing.scene;
    out[SceneLayout::ambient] = storable(scene.ambient);
    packOwn(out, pipeline.scene, scene, pipeline.effects);
    for (const BlockPlace& part : pipeline.scene.parts) {
        packPlace(out, part, partValues(part, scene.parts), exact, cameraToWorld);
    }
    PackedScene packed{static_cast<std::size_t>(pipeline.scene.firstLight), 0};
    packLights(packed, out, pipeline, packing, cameraToWorld);
    return packed;
}

void packMaterial(std::span<glm::vec4> out, const Pipeline& pipeline, const Material& material,
                  const PackedAround& around) {
    const double opacity = opacityOf(material, *pipeline.catalog);
    out[ObjectLayout::surface] =
        glm::vec4(std::clamp(static_cast<float>(opacity), 0.0f, 1.0f),
                  1.0 / (1.0 - passedShare(material, *pipeline.catalog)), 0.0f, 0.0f);
    if (pipeline.object.model) {
        packPlace(out, *pipeline.object.model, material.model.parameters, material.accuracy,
                  around);
    }
    for (const auto* places : {&pipeline.object.slots, &pipeline.object.parts}) {
        for (const BlockPlace& part : *places) {
            packPlace(out, part, partValues(part, material.parts), material.accuracy, around);
        }
    }
    packOwn(out, pipeline.object, material, pipeline.effects);
}

void packLines(std::span<glm::vec4> out, const OutlineLayout& layout, const Material& material,
               const PackedAround& around) {
    const std::span<glm::vec4> own = out.subspan(OutlineLayout::fixed);
    packInto(own, layout.block.layout, partValues(layout.block, material.parts), material.accuracy,
             around);
    packScreenLengths(own, layout.block, around.pixelRatio);
}

void packLayers(std::span<glm::vec4> out, const Pipeline& pipeline, const LayersToPack& packing,
                const glm::dmat4& cameraToWorld) {
    const ObjectLayout& layout = pipeline.object;
    packPlace(out, *layout.transparency, packing.values, exact, cameraToWorld);
    const double way = packing.farthest - packing.nearest;
    out[static_cast<std::size_t>(layout.layers())] =
        glm::vec4(packing.nearest, way > 1e-30 ? 1.0 / way : 0.0, 0.0, 0.0);
}

void packGround(std::span<glm::vec4> out, const Pipeline& pipeline, const Ground& ground,
                const GroundToPack& packing) {
    const GroundPlace& place = packing.place;
    const auto first = static_cast<std::size_t>(*pipeline.object.ground);
    out[first] = glm::vec4(glm::vec3(glm::clamp(ground.color, 0.0, 1.0)),
                           std::clamp(static_cast<float>(ground.opacity), 0.0f, 1.0f));
    out[first + 1] = glm::vec4(place.middle.x, place.middle.z, 1.0 / place.radius, 0.0);
    if (pipeline.scene.environment != nullptr) {
        out[first + 2] = storable(packing.environment);
    }
}

/// Returns the offset in clip space that moves a point back by a share of its distance, which is
/// the same at all distances. The share is limited by the picture's height, so that it is as
/// invisible through a long lens.
double farSide(const glm::dmat4& worldToClip, const glm::dvec3& eye) {
    constexpr double share = 1e-4;
    constexpr double shareOfHeight = 1.0 / 3000.0; // is a share of half the height
    const double zoom = glm::length(glm::dvec3(glm::row(worldToClip, 1)));
    const double eyeDepth = (worldToClip * glm::dvec4(eye, 1.0)).z;
    return -std::min(share, shareOfHeight / zoom) * eyeDepth;
}

void packView(std::span<glm::vec4> out, const glm::dmat4& worldToClip, const glm::dvec3& eye,
              double pixel) {
    for (int column = 0; column < 4; ++column) {
        out[static_cast<std::size_t>(ViewLayout::clip + column)] = glm::vec4(worldToClip[column]);
    }
    out[ViewLayout::eye] = glm::vec4(eye, pixel);
    out[ViewLayout::farSide] = glm::vec4(farSide(worldToClip, eye), 0.0, 0.0, 0.0);
}

} // namespace patina
