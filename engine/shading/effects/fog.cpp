// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/fog.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "catalog/settings.h"
#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/neutral_values.h"
#include "shading/effects/surface_text.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

/// Is the steepest that the sRGB curve is, at black.
constexpr double srgbSlope = 12.92;

/// Returns a number that the block's descriptor names, in its range.
double number(const Block& block, const Values& values, const std::string& id) {
    const Parameter* parameter = block.parameter(id);
    const double* held =
        parameter == nullptr ? nullptr : std::get_if<double>(&givenValue(*parameter, values));
    if (held == nullptr) {
        return 0.0;
    }
    return std::isfinite(*held) ? std::clamp(*held, parameter->min, parameter->max)
                                : std::get<double>(parameter->defaultValue);
}

double ramp(double from, double to, double distance) {
    if (!(to > from)) {
        return distance < to ? 0.0 : 1.0;
    }
    return std::clamp((distance - from) / (to - from), 0.0, 1.0);
}

/// Returns the brightest channel of the fog's colour; 1 where no parameter is that.
double brightness(const Block& block, const Values& values) {
    const Parameter* parameter = block.withRole(roles::color);
    const glm::dvec3* color =
        parameter == nullptr ? nullptr : std::get_if<glm::dvec3>(&givenValue(*parameter, values));
    return color == nullptr ? 1.0 : std::max({color->x, color->y, color->z, 0.0});
}

const glm::dvec3* vectorOf(const Parameter* parameter, const Values& values) {
    return parameter == nullptr ? nullptr
                                : std::get_if<glm::dvec3>(&givenValue(*parameter, values));
}

/// Returns the longest way through the box that the fog fills; infinite where it fills none.
double longestPath(const Block& block, const Values& values) {
    const glm::dvec3* size = vectorOf(block.parameter(block.hides->size), values);
    if (size == nullptr) {
        return std::numeric_limits<double>::infinity();
    }
    const bool isFlat = !(size->x > 0.0 && size->y > 0.0 && size->z > 0.0);
    return isFlat ? 0.0 : glm::length(*size);
}

/// Returns what fog is decided by: the next power of two, so that a camera that moves seldom asks
/// for other programs.
double decisive(double number) {
    return std::isfinite(number) && number > 0.0 ? std::exp2(std::ceil(std::log2(number))) : number;
}

std::string named(const Block& block, const Values& values, const std::string& id) {
    const Parameter* parameter = block.parameter(id);
    const std::string unit = parameter->unit == "m" ? " m" : "";
    return fmt::format("{} {:.4g}{}", parameter->label, number(block, values, id), unit);
}

/// Writes two digits, but for all of it.
std::string percentText(double share) {
    return share >= 0.995 ? "100" : fmt::format("{:.2g}", 100.0 * share);
}

/// Writes a share below half of an 8-bit step, 0.2 %.
std::string smallPercentText(double share) {
    return share < 1e-4 ? "less than 0.01" : fmt::format("at most {:.1g}", 100.0 * share);
}

std::string valuesText(const Block& block, const Values& values) {
    const Hiding& hides = *block.hides;
    std::string text;
    for (const std::string* id :
         {&hides.rate, &hides.from, &hides.to, &hides.base, &hides.thickness}) {
        if (!id->empty()) {
            text += (text.empty() ? "" : ", ") + named(block, values, *id);
        }
    }
    return text;
}

} // namespace

std::optional<double> hiddenShare(const Block& block, const Values& values, double distance,
                                  double thickness) {
    if (!block.hides) {
        return std::nullopt;
    }
    const Hiding& hides = *block.hides;
    if (hides.rate.empty()) {
        return ramp(number(block, values, hides.from), number(block, values, hides.to), distance);
    }
    const double rate = number(block, values, hides.rate);
    distance = std::min(distance, longestPath(block, values)) * thickness;
    const bool hidesAny = rate > 0.0 && distance > 0.0;
    return hidesAny ? -std::expm1(-std::pow(rate * distance, hides.power)) : 0.0;
}

std::optional<FogBox> fogBox(const Block& block, const Values& values) {
    if (!block.hides) {
        return std::nullopt;
    }
    const glm::dvec3* center = vectorOf(block.parameter(block.hides->center), values);
    const glm::dvec3* size = vectorOf(block.parameter(block.hides->size), values);
    const bool isBox =
        center != nullptr && size != nullptr && isFinite(Value(*center)) && isFinite(Value(*size));
    return isBox ? std::optional(FogBox{*center, *size}) : std::nullopt;
}

std::optional<FogLayer> fogLayer(const Block& block, const Values& values) {
    const bool isLayer = block.hides && !block.hides->base.empty();
    return isLayer ? std::optional(FogLayer{number(block, values, block.hides->base),
                                            number(block, values, block.hides->thickness)})
                   : std::nullopt;
}

/// Returns up to the base 1; above it the mean of exp(-y / thickness), a difference of two of them.
double FogLayer::between(double one, double other) const {
    const double low = std::min(one, other);
    const double high = std::max(one, other);
    const double scale = std::max(thickness, 1e-6); // as in the shader
    const double from = std::max(low - base, 0.0) / scale;
    const double to = std::max(high - base, 0.0) / scale;
    if (!(to > from)) {
        return std::exp(-from);
    }
    const double above = -std::exp(-from) * std::expm1(from - to) * scale;
    const double below = std::max(base - low, 0.0);
    return std::clamp((below + above) / (high - low), 0.0, 1.0);
}

/// With h the hidden share, a surface of S becomes S (1 - h) + F h. On a display that is, by the
/// slope of the sRGB curve at black, at most 12.92 F h more, and at most 0.44 h less, since
/// S times the curve's slope at S is never more than 0.44. Tone mapping subtracts a part of the
/// least channel, which can double both.
double maxChange(const Scene& scene, const Block& block, const EffectView& view) {
    const auto hidden =
        hiddenShare(block, scene.part(kinds::fog)->parameters, decisive(view.farthest),
                    std::min(decisive(view.fogThickness), 1.0));
    if (!hidden) {
        return std::numeric_limits<double>::infinity();
    }
    if (view.missesFog) {
        return 0.0;
    }
    const double light =
        brightness(block, scene.part(kinds::fog)->parameters) * std::exp2(scene.exposure);
    return *hidden > 0.0 ? 2.0 * *hidden * (srgbSlope * light + 0.44) : 0.0;
}

namespace {

bool canHide(const Scene& scene, const Block& block, const EffectView& view) {
    return !isNeutral(block, scene.part(kinds::fog)->parameters) &&
           maxChange(scene, block, view) >= halfStep;
}

/// Returns one sentence with the fog's values: how much it hides, or why nobody could see it.
std::string fogText(const Scene& scene, const Block& block, const EffectView& view) {
    if (!block.hides) {
        return "The scene has fog.";
    }
    const Values& values = scene.part(kinds::fog)->parameters;
    const std::string text = valuesText(block, values);
    if (longestPath(block, values) == 0.0) {
        return text + ": there is nothing in a box without a width, a height or a depth.";
    }
    if (view.missesFog) {
        return text + ": nothing that is drawn lies in its box or is seen through it.";
    }
    if (!std::isfinite(view.farthest)) {
        return text + ".";
    }
    const double change = maxChange(scene, block, view);
    EffectView even = view;
    even.fogThickness = 1.0;
    if (change < halfStep && !(maxChange(scene, block, even) < halfStep)) {
        return fmt::format("{}: it thins out below what is drawn, and changes its pixels by {} %.",
                           text, smallPercentText(change));
    }
    if (change < halfStep) {
        return fmt::format("{}: at up to {:.3g} m it changes no pixel by half of an 8-bit step.",
                           text, view.farthest);
    }
    return fmt::format("{}: at up to {:.3g} m it hides {}{} %.", text, view.farthest,
                       block.hides->atMost ? "at most " : "",
                       percentText(*hiddenShare(block, values, view.farthest, view.fogThickness)));
}

/// Writes the fog's block, and what the passes call it.
void writeFogBlock(SurfaceText& text) {
    const BlockUse& use = *text.set.fog;
    const Block& block = use.block();
    text.readFrom("sceneData");
    text.addBlock(block);
    text.addUnpack(use, "unpackFog");
    const std::string function = functionName(block);
    const char* share = text.isInspected() ? "fogShare(x, p) lookedShare({}(x, p))" : "fogShare {}";
    text.out.add(fmt::format("#define Fog {}\n#define {}\n#define fogColor {}Color\n",
                             structName(block), fmt::format(fmt::runtime(share), function),
                             function));
}

} // namespace

void FogEffect::choose(const SceneSubject& subject, const EffectSet&) {
    const auto& [scene, catalog, view, isGround] = subject;
    const Block* block =
        scene.part(kinds::fog) ? catalog.find(kinds::fog, scene.part(kinds::fog)->id) : nullptr;
    fog.reset();
    if (block != nullptr && canHide(scene, *block, view)) {
        fog.emplace(*block, scene.part(kinds::fog)->parameters);
    }
    fogsAtVertices = fog && scene.accuracy.fogsAtVertices();
}

void FogEffect::addTo(ChoiceHash& hash) const {
    hash.add(fog);
    hash.add(fogsAtVertices);
}

void FogEffect::list(EffectListing& listing, const EffectSet& set) const {
    if (fog) {
        const bool atVertices = fogsAtVertices && set.ground == GroundMode::Off;
        listing.add(effectName(*fog), detailed(compiledText(*fog), atVertices, "per vertex"),
                    [this](const EffectSubject& subject) {
                        return fogText(subject.scene, fog->block(), subject.view);
                    });
    }
}

void FogEffect::listMissing(LeftOutListing& listing, const EffectSet&) const {
    const auto& [material, scene, catalog, view] = listing.subject();
    if (fog || !scene.part(kinds::fog)) {
        return;
    }
    const Block* block = catalog.find(kinds::fog, scene.part(kinds::fog)->id);
    if (block == nullptr) {
        listing.add(std::string(kinds::fog),
                    fmt::format("No fog \"{}\" is known.", scene.part(kinds::fog)->id));
        return;
    }
    const std::string neutral = whyNeutral(*block, scene.part(kinds::fog)->parameters);
    listing.add(std::string(kinds::fog), neutral.empty() ? fogText(scene, *block, view) : neutral);
}

void FogEffect::place(SceneLayout& layout, const EffectSet&) const {
    if (fog) {
        layout.parts.push_back(placed(*fog, layout.firstLight));
    }
}

void FogEffect::write(SurfaceText& text) const {
    if (!fog) {
        return;
    }
    writeFogBlock(text);
    text.out.addFile(text.fogsAtVertices() ? "passes/blended_fog.glsl" : "passes/fog.glsl");
    if (text.set.ground == GroundMode::Shadows) {
        return; // they thin out with what they fall on
    }
    text.main += fmt::format("    shaded = fogged(s, shaded, unpackFog({}));\n",
                             text.scene.part(kinds::fog)->first);
    text.noteTerm("FOGGED", "shaded", "share");
}

std::string writeVertexFog(SurfaceText& text) {
    writeFogBlock(text);
    text.out.addFile("passes/vertex_fog.glsl");
    return fmt::format("    placeFog(unpackFog({}));\n", text.scene.part(kinds::fog)->first);
}

/// How much of the fog is seen depends on every value of it, on the exposure and on how far away
/// things are.
bool FogEffect::dependsOnPlaces(const Scene& scene, const Catalog&, std::string_view kind) {
    return scene.part(kinds::fog) != nullptr &&
           (kind == kinds::fog || kind == settings::scene || kind == settings::object);
}

void FogEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind == kinds::fog) {
        scene.setPart(kinds::fog, std::nullopt);
    }
}

} // namespace patina
