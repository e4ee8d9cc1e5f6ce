// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/stability/white_sky_albedo.h"

#include <array>
#include <cmath>

#include "core/color.h"
#include "measure/eval/model_values.h"
#include "measure/stability/hemisphere_rule.h"
#include "measure/stability/sweep_cases.h"

namespace patina {
namespace {

/// Is fine enough for the lobes that models have by default.
constexpr HemisphereRuleSize compiledRule{3, 0.35};
/// Has a third of the directions, for a model that is evaluated from its text, which takes a
/// hundred times as long. Lobes that models have by default lose 0.0005 by it at most, except a
/// grating's.
constexpr HemisphereRuleSize interpretedRule{2, 0.5};

/// Is a node of the rule over directions of the light. The square of the sine is uniform in
/// projected solid angle; the rule on its range 0 .. 1 is Gauss-Legendre with four nodes
/// (Abramowitz and Stegun 25.4.30).
struct LightNode {
    double sin2 = 0.0;
    double weight = 0.0;
};
constexpr std::array<LightNode, 4> lights{{{0.0694318442, 0.1739274226},
                                           {0.3300094782, 0.3260725774},
                                           {0.6699905218, 0.3260725774},
                                           {0.9305681558, 0.1739274226}}};

double directionalAlbedo(const ModelValues& model, double sin2) {
    const glm::dvec3 l(std::sqrt(sin2), 0.0, std::sqrt(1.0 - sin2));
    double sum = 0.0;
    for (const WeightedDirection& to :
         hemisphereRule(l, model.isCompiled() ? compiledRule : interpretedRule)) {
        sum += to.weight * luminance(model.at({l, to.v}));
    }
    return sum / l.z;
}

} // namespace

std::optional<double> whiteSkyAlbedo(const Catalog& catalog, const Block& model) {
    return whiteSkyAlbedo(catalog, defaultMaterial(model));
}

std::optional<double> whiteSkyAlbedo(const Catalog& catalog, const Material& material) {
    const Result<EvalCase> variant = sweepVariant(catalog, material);
    if (!variant) {
        return std::nullopt;
    }
    const auto values = ModelValues::of(*variant, catalog);
    if (!values) {
        return std::nullopt;
    }
    double sum = 0.0;
    for (const LightNode& light : lights) {
        sum += light.weight * directionalAlbedo(*values, light.sin2);
    }
    return values->isEndless() ? std::nullopt : std::optional(sum);
}

} // namespace patina
