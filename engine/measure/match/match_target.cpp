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

/// Returns the number of an index of the sequence of van der Corput in a base, 0 .. 1.
double radicalInverse(std::size_t index, std::size_t base) {
    double result = 0.0;
    double digit = 1.0;
    for (; index > 0; index /= base) {
        digit /= double(base);
        result += digit * double(index % base);
    }
    return result;
}

/// Returns a pair of directions by its half vector (dense around the normal) and the light around
/// it, of Halton's sequence.
DirectionPair haltonPair(std::size_t index) {
    const double root = radicalInverse(index, 2);
    const DirectionPair flat =
        directionsAt({root * root * 0.5 * pi, radicalInverse(index, 3) * 0.5 * pi,
                      radicalInverse(index, 5) * 2.0 * pi});
    const double azimuth = radicalInverse(index, 7) * 2.0 * pi;
    const auto turned = [azimuth](const glm::dvec3& v) {
        return glm::dvec3(v.x * std::cos(azimuth) - v.y * std::sin(azimuth),
                          v.x * std::sin(azimuth) + v.y * std::cos(azimuth), v.z);
    };
    return {turned(flat.l), turned(flat.v)};
}

} // namespace

MatchTarget MatchTarget::thinned(std::size_t count) const {
    if (count >= pairs.size()) {
        return *this;
    }
    MatchTarget fewer;
    fewer.isIsotropic = isIsotropic;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t taken = i * pairs.size() / count;
        fewer.pairs.push_back(pairs[taken]);
        fewer.values.push_back(values[taken]);
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
    return target.thinned(samples);
}

Result<MatchTarget> matchTarget(const EvalCase& model, std::size_t samples,
                                const Catalog& catalog) {
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
        const DirectionPair pair = haltonPair(index);
        if (isUsable(pair)) {
            target.pairs.push_back(pair);
            target.values.push_back(values->at(pair));
        }
    }
    if (values->isEndless()) {
        return tl::unexpected(endlessError(*model.block.block));
    }
    return target;
}

Result<MatchAim> matchAim(const Material& material, const Catalog& catalog, std::size_t samples) {
    return sweepVariant(catalog, material)
        .and_then([samples, &catalog](const EvalCase& model) {
            return matchTarget(model, samples, catalog);
        })
        .map([&material](MatchTarget target) {
            return MatchAim{std::move(target), material, {}};
        });
}

Checked<MatchAim> readMatchAim(const std::filesystem::path& file, const Catalog& catalog,
                               std::size_t samples) {
    if (isMeasuredFile(file)) {
        const auto target = readMeasured(file).and_then(
            [samples](const auto& measured) { return matchTarget(*measured, samples); });
        return target ? Checked<MatchAim>(MatchAim{*target, {}, {}})
                      : tl::unexpected(oneError(target.error()));
    }
    auto reading = readPreset(file, catalog);
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
