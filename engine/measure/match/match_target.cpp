// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/match/match_target.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "material/preset_file.h"
#include "measure/eval/model_values.h"
#include "measure/lobe/lobe_model.h"
#include "measure/stability/sweep_cases.h"
#include "measured/half_difference.h"

namespace patina {
namespace {

using std::numbers::pi;
const double minCosine = std::cos(80.0 * pi / 180.0);

bool isUsable(const DirectionPair& pair) {
    return pair.l.z > minCosine && pair.v.z > minCosine;
}

/// Counts the pairs on a ball of which one is of spreadPair().
constexpr std::size_t ballRow = 4;
constexpr double spreadWeight = 0.1 * double(ballRow);
constexpr double ballWeight = 0.9 * double(ballRow) / double(ballRow - 1);

/// Returns the pair of an index for a pixel of a ball's picture, as far as it is seen, and a light
/// from anywhere.
DirectionPair ballPair(std::size_t index) {
    const double radius = std::sqrt(radicalInverse(index, 2));
    const double height = radicalInverse(index, 3);
    const auto turned = [](double turn, double across, double along) {
        return glm::dvec3(across * std::cos(2.0 * pi * turn), across * std::sin(2.0 * pi * turn),
                          along);
    };
    return {turned(radicalInverse(index, 5), std::sqrt(1.0 - height * height), height),
            turned(radicalInverse(index, 7), radius, std::sqrt(1.0 - radius * radius))};
}

} // namespace

MatchTarget MatchTarget::first(std::size_t count) const {
    if (count >= pairs.size()) {
        return *this;
    }
    MatchTarget fewer;
    fewer.isIsotropic = isIsotropic;
    fewer.name = name;
    fewer.pairs.assign(pairs.begin(), pairs.begin() + std::ptrdiff_t(count));
    fewer.values.assign(values.begin(), values.begin() + std::ptrdiff_t(count));
    if (!weights.empty()) {
        fewer.weights.assign(weights.begin(), weights.begin() + std::ptrdiff_t(count));
    }
    return fewer;
}

Result<MatchTarget> matchTarget(const MeasuredReflectance& measured, std::size_t samples) {
    MatchTarget target;
    target.isIsotropic = measured.isIsotropic();
    for (const DirectionPair& pair : measured.samples(2 * samples)) {
        if (isUsable(pair)) {
            target.pairs.push_back(pair);
            target.values.push_back(pi * pair.l.z * measured.evaluate(pair));
        }
    }
    if (target.pairs.empty()) {
        return failure("nothing was measured within 80 degrees of the normal");
    }
    return target.first(samples);
}

Result<MatchTarget> matchTarget(const EvalCase& model, std::size_t samples, const Catalog& catalog,
                                MatchDirections directions) {
    if (const std::string why = whyNoReflectance(*model.block.block); !why.empty()) {
        return failure(why);
    }
    const Result<ModelValues> values = ModelValues::of(model, catalog);
    if (!values) {
        return tl::unexpected(values.error());
    }
    MatchTarget target;
    target.isIsotropic = false;
    for (std::size_t index = 1; target.pairs.size() < samples; ++index) {
        const bool isBall = directions == MatchDirections::LitBall;
        const bool isSpread = !isBall || index % ballRow == 0;
        // Each sequence goes through all its indices: a part of them would leave places out.
        const std::size_t rows = isBall ? index / ballRow : 0;
        const DirectionPair pair =
            isSpread ? spreadPair(isBall ? rows : index) : ballPair(index - rows);
        if (!isUsable(pair)) {
            continue;
        }
        target.pairs.push_back(pair);
        target.values.push_back(values->at(pair));
        if (isBall) {
            target.weights.push_back(isSpread ? spreadWeight : ballWeight);
        }
    }
    if (values->isEndless()) {
        return tl::unexpected(endlessError(*model.block.block));
    }
    return target;
}

Result<MatchAim> matchAim(const Material& material, const Catalog& catalog, std::size_t samples,
                          MatchDirections directions) {
    return sweepVariant(catalog, material)
        .and_then([samples, directions, &catalog](const EvalCase& model) {
            return matchTarget(model, samples, catalog, directions);
        })
        .map([&material](MatchTarget target) {
            target.name = material.name;
            return MatchAim{std::move(target), material, {}};
        });
}

Checked<MatchAim> readMatchAim(const std::filesystem::path& file, const Catalog& catalog,
                               std::size_t samples, const ReadingRights& rights) {
    if (isMeasuredFile(file)) {
        auto target = readMeasured(file).and_then(
            [samples](const auto& measured) { return matchTarget(*measured, samples); });
        if (!target) {
            return tl::unexpected(oneError(target.error()));
        }
        target->name = file.filename().string();
        return MatchAim{std::move(*target), {}, {}};
    }
    auto reading = readPreset(file, catalog, rights);
    if (!reading) {
        return tl::unexpected(reading.error());
    }
    auto aim = matchAim(reading->material, catalog, samples);
    if (!aim) {
        return tl::unexpected(oneError(aim.error()));
    }
    aim->notes = std::move(reading->notes);
    return std::move(*aim);
}

} // namespace patina
