// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/fresnel_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "catalog/index_trend.h"
#include "measure/eval/library_call.h"
#include "measure/lobe/fresnel_block.h"
#include "shading/program/compiled_block.h"

namespace patina {
namespace {

constexpr int termSteps = 180;

double versine(double angle) {
    const double s = std::sin(0.5 * angle);
    return 2.0 * s * s;
}

double cosine(double angle) {
    return std::max(std::cos(angle), 0.0);
}

/// Returns even steps, and closer ones about the angles where a side's curves touch 0 or 1.
std::vector<double> anglesOf(const InterfaceSide& side) {
    constexpr double beside[] = {0.0, 1e-5, 1e-4, 1e-3, 4e-3};
    std::vector<double> angles;
    for (int i = 0; i <= termSteps; ++i) {
        angles.push_back(0.5 * std::numbers::pi * i / termSteps);
    }
    for (const glm::dvec3& each : {side.brewster, side.critical}) {
        for (int channel = 0; channel < 3; ++channel) {
            for (const double step : beside) {
                angles.push_back(each[channel] - step);
                angles.push_back(each[channel] + step);
            }
        }
    }
    std::erase_if(angles,
                  [](double angle) { return angle < 0.0 || angle > 0.5 * std::numbers::pi; });
    std::ranges::sort(angles);
    angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
    return angles;
}

InterfaceSide sideOf(const OpticalInterface& media, bool fromInside) {
    InterfaceSide side;
    for (int channel = 0; channel < 3; ++channel) {
        const double ratio = fromInside ? media.outside / media.index[channel]
                                        : media.index[channel] / media.outside;
        side.brewster[channel] = libraryCall<1, 1>("brewsterAngle", {ratio})[0];
        side.critical[channel] = libraryCall<1, 1>("criticalAngle", {ratio})[0];
    }
    for (const double angle : anglesOf(media.isClear() ? side : InterfaceSide())) {
        side.points.push_back(reflectedAt(media, angle, fromInside));
    }
    return side;
}

std::vector<FresnelPoint> termOf(const ValuedBlock& chosen, const reference::Block& code,
                                 const AccuracyLevels& levels) {
    const std::vector<double> packedChosen = packed(*chosen.block, chosen.values, levels);
    const std::vector<double> packedExact = packed(*chosen.block, chosen.values, {});
    std::vector<FresnelPoint> points;
    for (int i = 0; i <= termSteps; ++i) {
        const double angle = 0.5 * std::numbers::pi * i / termSteps;
        points.push_back({angle, code.fresnel(cosine(angle), versine(angle), packedChosen),
                          code.fresnel(cosine(angle), versine(angle), packedExact)});
    }
    return points;
}

} // namespace

std::optional<OpticalInterface> interfaceOf(const Block& fresnel, const Values& values) {
    OpticalInterface media;
    const ValuedBlock of{&fresnel, values};
    media.outside = of.number(roles::indexOutside).value_or(1.0);
    if (const auto indices = workedOutIndices(of)) {
        media.index = *indices;
        return media;
    }
    if (const auto inside = of.number(roles::indexInside)) {
        media.index = glm::dvec3(indexAtTemperature(fresnel, values, *inside));
        return media;
    }
    const auto index = of.vector(roles::index);
    const auto extinction = of.vector(roles::extinction);
    if (index && extinction) {
        media.index = *index;
        media.extinction = *extinction;
        return media;
    }
    if (const auto f0 = of.vector(roles::f0)) {
        for (int channel = 0; channel < 3; ++channel) {
            media.index[channel] =
                libraryCall<1, 1>("indexFromF0", {std::clamp((*f0)[channel], 0.0, 1.0)})[0];
        }
        media.isFromReflectance = true;
        return media;
    }
    return std::nullopt;
}

PolarisedPoint reflectedAt(const OpticalInterface& media, double angle, bool fromInside) {
    PolarisedPoint point{angle, glm::dvec3(0.0), glm::dvec3(0.0)};
    const double c = cosine(angle);
    const double v = std::min(versine(angle), 1.0);
    for (int channel = 0; channel < 3; ++channel) {
        const double index = media.index[channel];
        const std::array<double, 2> both =
            media.isClear()
                ? libraryCall<2, 4>("dielectricReflectances",
                                    {c, v, fromInside ? index : media.outside,
                                     fromInside ? media.outside : index})
                : libraryCall<2, 5>("conductorReflectances",
                                    {c, v, media.outside, index, media.extinction[channel]});
        point.s[channel] = both[0];
        point.p[channel] = both[1];
    }
    return point;
}

Result<FresnelCurves> fresnelCurves(const Catalog& catalog, const Material& material) {
    const Result<ValuedBlock> chosen = fresnelBlock(catalog, material);
    if (!chosen) {
        return tl::unexpected(chosen.error());
    }
    const auto code = compiledBlock(*chosen->block);
    if (!code) {
        return tl::unexpected(code.error());
    }
    FresnelCurves curves;
    curves.label = chosen->block->label;
    curves.term = termOf(*chosen, **code, material.accuracy);
    curves.media = interfaceOf(*chosen->block, chosen->values);
    if (curves.media) {
        curves.fromOutside = sideOf(*curves.media, false);
        if (curves.media->letsLightOut()) {
            curves.fromInside = sideOf(*curves.media, true);
        }
    }
    return curves;
}

} // namespace patina
