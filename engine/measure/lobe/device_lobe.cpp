// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/device_lobe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/vectors.h"
#include "measure/eval/model_values.h"
#include "measure/stability/hemisphere_rule.h"

namespace patina {
namespace {

constexpr double stepOfDevice = std::numbers::pi / 360.0;
constexpr double stepOfErrors = std::numbers::pi / 180.0;
constexpr HemisphereRuleSize deviceRule{3, 0.35};

/// Returns even angles across the hemisphere, with closer ones about the mirror direction.
std::vector<double> anglesAcross(const Incoming& incoming, double step) {
    constexpr double beside[] = {0.0, 1e-4, 3e-4, 1e-3, 2e-3, 4e-3, 8e-3};
    std::vector<double> angles;
    const int steps = static_cast<int>(std::lround(std::numbers::pi / step));
    for (int i = 0; i <= steps; ++i) {
        angles.push_back(0.5 * std::numbers::pi * (2.0 * i / steps - 1.0));
    }
    for (const double each : beside) {
        angles.push_back(incoming.angle - each);
        angles.push_back(incoming.angle + each);
    }
    std::erase_if(angles, [](double angle) { return std::abs(angle) > 0.5 * std::numbers::pi; });
    std::ranges::sort(angles);
    angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
    return angles;
}

Incoming inRange(const Incoming& incoming) {
    return {std::clamp(incoming.angle, 0.0, maxIncoming), incoming.azimuth};
}

std::vector<glm::dvec3> viewersAt(const Incoming& incoming, const std::vector<double>& angles) {
    std::vector<glm::dvec3> viewers;
    for (const double angle : angles) {
        viewers.push_back(incoming.across(angle));
    }
    return viewers;
}

std::vector<EvalCase> casesOf(const EvalCase& request, const glm::dvec3& l,
                              std::span<const glm::dvec3> viewers) {
    std::vector<EvalCase> cases(viewers.size(), request);
    for (std::size_t i = 0; i < viewers.size(); ++i) {
        cases[i].gpu = true;
        cases[i].l = l;
        cases[i].v = viewers[i];
    }
    return cases;
}

glm::dvec3 inFloats(const glm::dvec3& v) {
    return glm::dvec3(glm::vec3(v));
}

/// Returns how far a number is from the exact one, in units in the last place of the exact one as a
/// float.
double ulpsBetween(double number, double exact) {
    const float rounded = static_cast<float>(std::abs(exact));
    const float smallest = std::numeric_limits<float>::min(); // below it floats lose digits anyway
    const float from = std::max(rounded, smallest);
    const double unit =
        double(std::nextafter(from, std::numeric_limits<float>::max())) - double(from);
    const double ulps = std::abs(number - exact) / unit;
    return std::isfinite(ulps) ? ulps : 0.0;
}

glm::dvec3 valueFrom(const std::vector<double>& numbers) {
    const glm::dvec3 value(numbers.at(0), numbers.at(1), numbers.at(2));
    return isFinite(value) ? glm::max(value, glm::dvec3(0.0)) : glm::dvec3(0.0);
}

/// Returns the model's values, pi f cos(theta_l).
Result<std::vector<glm::dvec3>> deviceValues(EvalGpu& device, const Catalog& catalog,
                                             std::span<const EvalCase> cases) {
    std::vector<glm::dvec3> values;
    for (const auto& answer : device.evaluate(cases, catalog)) {
        if (!answer) {
            return tl::unexpected(answer.error());
        }
        values.push_back(valueFrom(*answer));
    }
    return values;
}

} // namespace

Result<std::vector<glm::dvec3>> deviceReflectances(EvalGpu& device, const Catalog& catalog,
                                                   const EvalCase& request, const glm::dvec3& l,
                                                   std::span<const glm::dvec3> viewers) {
    auto values = deviceValues(device, catalog, casesOf(request, l, viewers));
    if (values) {
        for (glm::dvec3& value : *values) {
            value = l.z > 0.0 ? value / (std::numbers::pi * l.z) : glm::dvec3(0.0);
        }
    }
    return values;
}

Result<std::vector<LobePoint>> devicePolarCurve(EvalGpu& device, const Catalog& catalog,
                                                const EvalCase& request, const Incoming& incoming) {
    const Incoming lit = inRange(incoming);
    const std::vector<double> angles = anglesAcross(lit, stepOfDevice);
    const auto f =
        deviceReflectances(device, catalog, request, lit.direction(), viewersAt(lit, angles));
    if (!f) {
        return tl::unexpected(f.error());
    }
    std::vector<LobePoint> curve;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        curve.push_back({angles[i], (*f)[i]});
    }
    return curve;
}

Result<std::vector<AlbedoPoint>> deviceAlbedoCurve(EvalGpu& device, const Catalog& catalog,
                                                   const EvalCase& request, double azimuth) {
    std::vector<AlbedoPoint> curve;
    for (const double degrees : {0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0, 88.0}) {
        const Incoming incoming{degrees * std::numbers::pi / 180.0, azimuth};
        const glm::dvec3 l = incoming.direction();
        const auto rule = hemisphereRule(l, deviceRule);
        std::vector<glm::dvec3> viewers;
        for (const WeightedDirection& each : rule) {
            viewers.push_back(each.v);
        }
        const auto values = deviceValues(device, catalog, casesOf(request, l, viewers));
        if (!values) {
            return tl::unexpected(values.error());
        }
        glm::dvec3 sum(0.0);
        for (std::size_t i = 0; i < rule.size(); ++i) {
            sum += rule[i].weight * (*values)[i];
        }
        curve.push_back({incoming.angle, sum / l.z, 0.0});
    }
    return curve;
}

PlaneCases planeCases(const EvalCase& request, const Incoming& incoming) {
    const Incoming lit = inRange(incoming);
    PlaneCases plane{anglesAcross(lit, stepOfErrors), {}};
    std::vector<glm::dvec3> viewers = viewersAt(lit, plane.angles);
    std::ranges::transform(viewers, viewers.begin(), inFloats);
    plane.cases = casesOf(request, inFloats(lit.direction()), viewers);
    return plane;
}

Result<std::vector<FloatError>> floatErrors(EvalGpu& device, const Catalog& catalog,
                                            const EvalCase& request, const Incoming& incoming) {
    const auto [angles, cases] = planeCases(request, incoming);
    const auto exactValues = ModelValues::of(request, catalog);
    if (!exactValues) {
        return tl::unexpected(exactValues.error());
    }
    const auto values = deviceValues(device, catalog, cases);
    if (!values) {
        return tl::unexpected(values.error());
    }
    std::vector<FloatError> errors;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const glm::dvec3 exact =
            exactValues->at({glm::normalize(cases[i].l), glm::normalize(cases[i].v)});
        FloatError error{angles[i], glm::dvec3(0.0)};
        for (int channel = 0; channel < 3; ++channel) {
            error.ulps[channel] = ulpsBetween((*values)[i][channel], exact[channel]);
        }
        errors.push_back(error);
    }
    if (exactValues->isEndless()) {
        return tl::unexpected(endlessError(*request.block.block));
    }
    return errors;
}

} // namespace patina
