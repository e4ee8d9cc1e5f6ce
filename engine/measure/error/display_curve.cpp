// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/display_curve.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "core/color.h"

namespace patina {
namespace {

/// Beyond this a half float's whole range is black or white.
constexpr double maxStops = 40.0;

/// Khronos PBR Neutral (2024), as passes/tone_neutral.glsl.
glm::dvec3 neutral(const glm::dvec3& light) {
    constexpr double start = 0.8 - 0.04;
    constexpr double desaturation = 0.15;
    const double minChannel = std::min({light.r, light.g, light.b});
    const double offset = minChannel < 0.08 ? minChannel - 6.25 * minChannel * minChannel : 0.04;
    const glm::dvec3 color = light - offset;
    const double peak = std::max({color.r, color.g, color.b});
    if (peak < start) {
        return color;
    }
    constexpr double rest = 1.0 - start;
    const double newPeak = 1.0 - rest * rest / (peak + rest - start);
    const double bleach = 1.0 - 1.0 / (desaturation * (peak - newPeak) + 1.0);
    return glm::mix(color * (newPeak / peak), glm::dvec3(newPeak), bleach);
}

} // namespace

double DisplayCurve::factor() const {
    return std::exp2(std::clamp(exposure, -maxStops, maxStops));
}

glm::dvec3 DisplayCurve::shown(const glm::dvec3& light) const {
    const glm::dvec3 exposed = glm::min(light * factor(), glm::dvec3(1e30));
    return srgbEncoded(toneMapping == ToneMapping::None ? exposed : neutral(exposed));
}

} // namespace patina
