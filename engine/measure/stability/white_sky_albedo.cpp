// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/stability/white_sky_albedo.h"

#include <array>
#include <cmath>

#include "core/color.h"
#include "measure/eval/reference_case.h"
#include "measure/stability/hemisphere_rule.h"
#include "measure/stability/sweep_cases.h"

namespace patina {
namespace {

/// Is fine enough for the lobes that models have by default.
constexpr HemisphereRuleSize rule{3, 0.35};

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

glm::dvec3 shading(const ReferenceNumbers& numbers) {
    return {numbers[0], numbers[1], numbers[2]};
}

double directionalAlbedo(const ReferenceCase& model, double sin2) {
    EvalPlace place;
    place.l = {std::sqrt(sin2), 0.0, std::sqrt(1.0 - sin2)};
    double sum = 0.0;
    for (const WeightedDirection& to : hemisphereRule(place.l, rule)) {
        place.v = to.v;
        sum += to.weight * luminance(shading(model.evaluate(place)));
    }
    return sum / place.l.z;
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
    const auto code = ReferenceCode::find(*variant);
    if (!code) {
        return std::nullopt;
    }
    const ReferenceCase compiled(*code, variant->block.packedValues(),
                                 variant->slot.block == nullptr ? std::vector<double>()
                                                                : variant->slot.packedValues());
    double sum = 0.0;
    for (const LightNode& light : lights) {
        sum += light.weight * directionalAlbedo(compiled, light.sin2);
    }
    return sum;
}

} // namespace patina
