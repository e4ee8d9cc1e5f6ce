// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/scaling_curve.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "measure/cost/cost_table.h"

namespace patina {
namespace {

struct Unit {
    double count = 1.0;
    const char* name = "";
};

Unit unitOf(ScalingCurve::Axis axis) {
    switch (axis) {
    case ScalingCurve::Axis::Pixels:
        return {1e6, "million pixels"};
    case ScalingCurve::Axis::Lights:
        return {1.0, "light"};
    default:
        return {1.0, "object"};
    }
}

nlohmann::json lawJson(const std::optional<GrowthLaw>& law) {
    return law ? nlohmann::json{{"base", law->base},         {"each", law->each},
                                {"fit", law->fit},           {"exponent", law->exponent},
                                {"isLinear", law->shape() == GrowthLaw::Shape::Linear}}
               : nlohmann::json();
}

nlohmann::json curveJson(const ScalingCurve& curve) {
    nlohmann::json samples = nlohmann::json::array();
    for (const GrowthSample& sample : curve.samples) {
        samples.push_back({{"count", sample.count},
                           {"milliseconds", intervalJson(sample.milliseconds, sample.runs)},
                           {"runs", sample.runs}});
    }
    return {{"axis", axisText(curve.axis)},
            {"samples", samples},
            {"law", lawJson(curve.law)},
            {"text", lawText(curve)}};
}

} // namespace

std::string axisText(ScalingCurve::Axis axis) {
    switch (axis) {
    case ScalingCurve::Axis::Pixels:
        return "pixels";
    case ScalingCurve::Axis::Lights:
        return "lights";
    default:
        return "objects";
    }
}

std::string plainNumber(double number, char format, int digits) {
    const bool isFixed = format == 'f' || number == 0.0 || !std::isfinite(number);
    const int before =
        isFixed ? 0 : static_cast<int>(std::floor(std::log10(std::abs(number)))) + 1;
    std::string text = fmt::format("{:.{}f}", number, std::max(digits - before, 0));
    if (format != 'f' && text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') {
            text.pop_back();
        }
    }
    return text;
}

std::string lawText(const ScalingCurve& curve, const NumberText& number) {
    if (!curve.law) {
        return "too few times for a law";
    }
    const GrowthLaw& law = *curve.law;
    const Unit unit = unitOf(curve.axis);
    const std::string base = number(std::abs(law.base), 'g', 3);
    const std::string each = number(std::abs(law.each) * unit.count, 'g', 3);
    const std::string fit = number(law.fit, 'f', 3);
    switch (law.shape()) {
    case GrowthLaw::Shape::Constant:
        return fmt::format("constant: within {} %", number(100.0 * (law.spread - 1.0), 'f', 0));
    case GrowthLaw::Shape::Linear:
        return law.base < 0.0
                   ? fmt::format("linear: {} ms per {} - {} ms, R² {}", each, unit.name, base, fit)
                   : fmt::format("linear: {} ms {} {} ms per {}, R² {}", base,
                                 law.each < 0.0 ? "-" : "+", each, unit.name, fit);
    default:
        return fmt::format("twice the {} take {} times as long; a straight line has R² {}",
                           axisText(curve.axis), number(std::exp2(law.exponent), 'g', 3), fit);
    }
}

std::string scalingText(const std::vector<ScalingCurve>& curves) {
    std::string text;
    bool unsure = false;
    for (const ScalingCurve& curve : curves) {
        text += fmt::format("{:>9} {:>10} {}\n", axisText(curve.axis), "ms", "(of 95 % of runs)");
        for (const GrowthSample& sample : curve.samples) {
            const MedianInterval& time = sample.milliseconds;
            unsure = unsure || !sample.isSure();
            text += fmt::format("{:9.0f} {:10.3f} ({:.3f} .. {:.3f}){}\n", sample.count,
                                time.median, time.lower, time.upper, sample.isSure() ? "" : "!");
        }
        text += lawText(curve) + "\n";
    }
    return unsure ? text + "! too few runs for an interval: from the least to the greatest\n"
                  : text;
}

std::string scalingCsv(const std::vector<ScalingCurve>& curves) {
    std::string text = "axis,count,milliseconds,milliseconds_lower,milliseconds_upper,runs\n";
    for (const ScalingCurve& curve : curves) {
        for (const GrowthSample& sample : curve.samples) {
            const MedianInterval& time = sample.milliseconds;
            text += fmt::format("{},{},{},{},{}\n", axisText(curve.axis), sample.count,
                                time.median, boundsCsv(time, sample.runs), sample.runs);
        }
    }
    return text;
}

nlohmann::json scalingJson(const std::vector<ScalingCurve>& curves) {
    nlohmann::json json = nlohmann::json::array();
    for (const ScalingCurve& curve : curves) {
        json.push_back(curveJson(curve));
    }
    return json;
}

} // namespace patina
