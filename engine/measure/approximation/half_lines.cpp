// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/half_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "material/measured_preset.h"
#include "measure/approximation/measured_text.h"
#include "measure/lobe/device_lobe.h"
#include "measure/stability/sweep_cases.h"

namespace patina {
namespace {

constexpr int digitsOfHalf = 11;
constexpr int smallestOfHalf = -24; ///< is the exponent of its smallest number
constexpr double noDigitLeft = 2048.0;

double halfUlps(double number, double exact) {
    if (!std::isfinite(number)) {
        return noDigitLeft;
    }
    const int exponent = exact == 0.0 ? smallestOfHalf : std::ilogb(exact) - (digitsOfHalf - 1);
    return std::abs(number - exact) / std::ldexp(1.0, std::max(exponent, smallestOfHalf));
}

std::string worstText(const LobeLine& line, std::size_t broken) {
    double worst = 0.0;
    double at = 0.0;
    for (std::size_t i = 0; i < line.at.size(); ++i) {
        const glm::dvec3& each = line.values[i];
        if (const double here = std::max({each.x, each.y, each.z}); here > worst) {
            worst = here;
            at = line.at[i];
        }
    }
    return fmt::format(
        "at worst {:.3g} units in the last place of 16 bits (a value has 2048), {:.3g} degrees "
        "from the normal{}",
        worst, std::abs(at),
        broken > 0 ? fmt::format("; not finite at {} of {} angles", broken, line.at.size()) : "");
}

} // namespace

Result<LobeLines> halfLines(const Catalog& catalog, const Material& material,
                            const LobeRequest& request, const std::filesystem::path& shaders) {
    const Block* block = catalog.find(kinds::models, material.model.id);
    if (block != nullptr && !whyNoPlots(*block).empty()) {
        return failure(whyNoPlots(*block), "a model of a reflectance");
    }
    if (block != nullptr && tableParameter(*block) != nullptr) {
        return failure("a measured surface is read from a table and has no terms of its own to "
                       "compute in 16 bits",
                       "a model with formulas");
    }
    const Result<EvalCase> variant = sweepVariant(catalog, material);
    if (!variant) {
        return tl::unexpected(variant.error());
    }
    const auto values = ModelValues::of(*variant, catalog);
    if (!values) {
        return tl::unexpected(values.error());
    }
    const auto text = MeasuredText::of(*variant, shaders);
    if (!text) {
        return tl::unexpected(text.error().front());
    }
    const PlaneCases plane = planeCases(*variant, request.incoming);
    const JudgedCases exact = text->judged(texelsOfCases(plane.cases));
    const std::vector<double> half = text->valuesInHalf(text->ownFloats(), exact.texels);
    LobeLines all;
    LobeLine& line = all.lines.emplace_back();
    line.name = "float16 error";
    std::size_t broken = 0;
    for (std::size_t i = 0; i < plane.cases.size(); ++i) {
        values->at({plane.cases[i].l, plane.cases[i].v});
        glm::dvec3 ulps(0.0);
        bool isFinite = true;
        for (int channel = 0; channel < 3; ++channel) {
            const std::size_t place = i * text->results() + std::size_t(channel);
            ulps[channel] = halfUlps(half[place], exact.exact[place]);
            isFinite = isFinite && std::isfinite(half[place]);
        }
        broken += isFinite ? 0 : 1;
        line.at.push_back(plane.angles[i] * 180.0 / std::numbers::pi);
        line.values.push_back(ulps);
    }
    if (values->isEndless()) {
        return tl::unexpected(endlessError(*block));
    }
    all.note = worstText(line, broken);
    return all;
}

} // namespace patina
