// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/light_colors.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "shading/effects/surface_text.h"
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

bool isDiffuse(const Parameter& parameter) {
    return parameter.role == roles::diffuse;
}

/// Writes the function that leaves the highlight of a model's values; false where the model does
/// not tell it apart.
bool writeHighlightAlone(SurfaceText& text) {
    const Block& model = text.set.model->block();
    if (std::ranges::none_of(model.parameters, isDiffuse)) {
        return false;
    }
    std::string code = "Model highlightAlone(Model p) {\n";
    for (const Parameter& parameter : model.parameters) {
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
