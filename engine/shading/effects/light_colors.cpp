// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/light_colors.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "catalog/unit_direction.h"
#include "core/text.h"
#include "shading/effects/surface_text.h"
#include "shading/program/block_source.h"
#include "shading/program/compiled_block.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

glm::dvec3 colorOf(const Block& light, const Values& values, std::string_view role,
                   const glm::dvec3& none) {
    const Parameter* parameter = light.withRole(role);
    const auto* given =
        parameter == nullptr ? nullptr : std::get_if<glm::dvec3>(&givenValue(*parameter, values));
    if (given == nullptr) {
        return none;
    }
    glm::dvec3 color = *given;
    for (int channel = 0; channel < 3; ++channel) {
        const double number = std::isfinite(color[channel]) ? color[channel] : none[channel];
        color[channel] = std::clamp(number, parameter->min, parameter->max);
    }
    return color;
}

/// Returns the expression of a field of the struct `p` by its role; empty where there is none.
std::string fieldOf(const Block& block, std::string_view role) {
    const Parameter* parameter = block.withRole(role);
    return parameter == nullptr ? std::string() : "p." + fieldName(parameter->id);
}

/// Returns an expression for how differently one channel is reflected, by the indices that the
/// block's roles name; empty where these name no interface. A film, whose wavelengths matter, is
/// none.
std::string polarisedChannel(const Block& block, std::string_view channel) {
    const std::string outside = fieldOf(block, roles::indexOutside);
    const std::string inside = fieldOf(block, roles::indexInside);
    const std::string index = fieldOf(block, roles::index);
    const std::string extinction = fieldOf(block, roles::extinction);
    if (block.withRole(roles::wavelengths) != nullptr) {
        return {};
    }
    if (!outside.empty() && !inside.empty()) {
        return fmt::format("polarisedDielectric(i, {}, {})", outside, inside);
    }
    if (!index.empty() && !extinction.empty()) {
        return fmt::format("polarisedConductor(i, {}, {}.{}, {}.{})",
                           outside.empty() ? "1.0" : outside, index, channel, extinction, channel);
    }
    return {};
}

/// Tells whether the block itself says what it reflects of light that swings across the plane of
/// incidence.
bool tellsAcross(const Block& block) {
    const auto code = compiledBlock(block);
    return code && (*code)->optionalCall(reference::acrossSuffix) != nullptr;
}

/// Tells whether the block names what reflects: an interface, or how much of it does facing it.
bool knowsPolarisation(const Block& fresnel) {
    return !polarisedChannel(fresnel, "x").empty() || tellsAcross(fresnel) ||
           fresnel.withRole(roles::f0) != nullptr;
}

/// Returns the statement that ends the function: the share of light of any polarisation, from that
/// of ordinary light.
std::string polarisedShare(const Block& fresnel) {
    if (tellsAcross(fresnel)) {
        return fmt::format("    return polarisedOf(ordinary, {}{}(i, p));\n", functionName(fresnel),
                           reference::acrossSuffix);
    }
    if (!polarisedChannel(fresnel, "x").empty()) {
        return fmt::format("    return ordinary * vec3({}, {}, {});\n",
                           polarisedChannel(fresnel, "x"), polarisedChannel(fresnel, "y"),
                           polarisedChannel(fresnel, "z"));
    }
    const std::string f0 = fieldOf(fresnel, roles::f0);
    return fmt::format("    vec3 facing = {};\n"
                       "    return ordinary * vec3(polarisedF0(i, facing.x, ordinary.x),\n"
                       "        polarisedF0(i, facing.y, ordinary.y),\n"
                       "        polarisedF0(i, facing.z, ordinary.z));\n",
                       f0.empty() ? functionName(fresnel) + "(incidenceOf(1.0), p)" : f0);
}

bool isDiffuse(const Parameter& parameter) {
    return parameter.role == roles::diffuse;
}

/// Writes the function that leaves the highlight of a model's values; false where the model does
/// not tell it apart, and on the ground, which has none.
bool writeHighlightAlone(SurfaceText& text) {
    if (!text.set.model || std::ranges::none_of(text.set.model->block().parameters, isDiffuse)) {
        return false;
    }
    std::string code = "Model highlightAlone(Model p) {\n";
    for (const Parameter& parameter : text.set.model->block().parameters) {
        if (isDiffuse(parameter)) {
            code += fmt::format("    p.{} = vec3(0.0);\n", fieldName(parameter.id));
        }
    }
    text.addOnce(code + "    return p;\n}\n");
    return true;
}

} // namespace

LightColors lightColors(const Block& light, const Values& values) {
    const LightColors none;
    return {colorOf(light, values, roles::diffuseColor, none.diffuse),
            colorOf(light, values, roles::highlightColor, none.highlight),
            colorOf(light, values, roles::ambientColor, none.ambient)};
}

LightPolarisation lightPolarisation(const Block& light, const Values& values) {
    LightPolarisation found;
    if (const Parameter* degree = light.withRole(roles::polarised)) {
        const auto* number = std::get_if<double>(&givenValue(*degree, values));
        found.degree =
            number != nullptr && std::isfinite(*number) ? std::clamp(*number, 0.0, 1.0) : 0.0;
    }
    if (const Parameter* direction = light.withRole(roles::fieldDirection)) {
        const auto* given = std::get_if<glm::dvec3>(&givenValue(*direction, values));
        found.direction = given == nullptr ? found.direction : unitDirection(*given);
    }
    return found;
}

bool answersPolarisedLight(const EffectSet& set) {
    return std::ranges::any_of(set.lights, &LightGroup::isPolarised) &&
           std::ranges::any_of(
               set.slots, [](const BlockUse& slot) { return slot.block().kind == kinds::fresnel; });
}

std::string polarisationNote(const EffectSet& set, const Block& fresnel) {
    const bool isNeeded = std::ranges::any_of(set.lights, &LightGroup::isPolarised) &&
                          fresnel.kind == kinds::fresnel && !knowsPolarisation(fresnel);
    return isNeeded ? " It names no index: polarised light is mirrored as by the clear material "
                      "that mirrors as much facing it."
                    : "";
}

void writePolarisedFresnel(SurfaceText& text, const Block& fresnel) {
    text.out.addFile("passes/polarised.glsl");
    std::string code = fmt::format("vec3 polarisedFresnel(Incidence i, {} p) {{\n"
                                   "    vec3 ordinary = {}(i, p);\n",
                                   structName(fresnel), functionName(fresnel));
    if (const std::string filter = fieldOf(fresnel, roles::polarisation); !filter.empty()) {
        const std::string constant =
            constantCase(structName(fresnel)) + '_' +
            constantCase(fieldName(fresnel.withRole(roles::polarisation)->id)) + '_';
        code += fmt::format("    if ({0} == {1}S) {{\n"
                            "        return 2.0 * fieldAcross * ordinary;\n"
                            "    }}\n"
                            "    if ({0} == {1}P) {{\n"
                            "        return (2.0 - 2.0 * fieldAcross) * ordinary;\n"
                            "    }}\n",
                            filter, constant);
    }
    code += fmt::format("{0}}}\n#undef {1}\n#define {1} polarisedFresnel\n",
                        polarisedShare(fresnel), slotFunctionName(fresnel.kind));
    text.out.add(code);
}

std::string writeSeparateColors(SurfaceText& text, const std::string& from, int colors) {
    const std::string function = from + "InColors";
    // A model that does not tell its highlight apart is lit as if it were all diffuse.
    const std::string highlight = writeHighlightAlone(text)
                                      ? fmt::format("{}(s, highlightAlone(p), base)", from)
                                      : std::string("vec3(0.0)");
    text.out.add(fmt::format("vec3 {0}(Surface s, Model p, int base) {{\n"
                             "    vec3 highlight = {2};\n"
                             "    vec3 diffuse = max({1}(s, p, base) - highlight, vec3(0.0));\n"
                             "    return sceneData[base + {3}].rgb * diffuse +\n"
                             "        sceneData[base + {4}].rgb * highlight;\n"
                             "}}\n",
                             function, from, highlight, colors, colors + 1));
    return function;
}

std::string writeLightAmbient(SurfaceText& text, const LightGroup& group, std::size_t index,
                              int colors) {
    const Block& block = group.block.block();
    const std::string function = fmt::format("ambientFrom{}{}", structName(block), index);
    text.out.add(fmt::format("vec3 {0}(Surface s, int base) {{\n"
                             "    return sceneData[base + {4}].rgb *\n"
                             "        {1}(s.x, unpack{2}{3}(base)).radiance;\n"
                             "}}\n",
                             function, functionName(block), structName(block), index, colors + 2));
    return function;
}

} // namespace patina
