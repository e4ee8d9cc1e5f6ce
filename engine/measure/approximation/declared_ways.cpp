// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/declared_ways.h"

#include <algorithm>
#include <limits>

#include "measure/approximation/error_climb.h"
#include "measure/approximation/shader_price.h"

namespace patina {
namespace {

/// Returns all combinations of levels but the exact one.
std::vector<AccuracyLevels> combinationsOf(const Block& block) {
    std::vector<AccuracyLevels> all{{}};
    for (const AccuracyChoice& choice : block.accuracy) {
        std::vector<AccuracyLevels> more = all;
        for (std::size_t i = 1; i < choice.values.size(); ++i) {
            for (AccuracyLevels levels : all) {
                levels[choice.id] = choice.values[i].id;
                more.push_back(std::move(levels));
            }
        }
        all = std::move(more);
    }
    all.erase(all.begin());
    return all;
}

EvalCase withLevels(EvalCase subject, const AccuracyLevels& levels) {
    for (const auto& [choice, level] : levels) {
        subject.block.accuracy[choice] = level;
    }
    return subject;
}

CaseTexels texelsWith(std::vector<EvalCase> cases, const AccuracyLevels& levels) {
    for (EvalCase& each : cases) {
        each = withLevels(std::move(each), levels);
    }
    return texelsOfCases(cases);
}

} // namespace

Checked<std::vector<DeclaredWay>> declaredWays(const EvalCase& subject,
                                               const std::filesystem::path& shaders,
                                               const GpuFamily& family, const CaseWish& cases,
                                               const std::function<bool()>& isStopped) {
    const auto exact = MeasuredText::of(subject, shaders);
    if (!exact) {
        return tl::unexpected(exact.error());
    }
    const std::vector<EvalCase> common = commonCases(subject, cases);
    const JudgedCases judged = exact->judged(texelsOfCases(common));
    std::vector<DeclaredWay> ways;
    for (const AccuracyLevels& levels : combinationsOf(*subject.block.block)) {
        const EvalCase level = withLevels(subject, levels);
        const auto text = MeasuredText::of(level, shaders);
        if (!text || isStopped()) {
            continue;
        }
        ShaderPrice price(level, text->source(), text->syntax(), family);
        const auto cost = price.of({{}}, isStopped).front();
        if (!cost) {
            continue;
        }
        const JudgedCases same{texelsWith(common, levels), judged.exact};
        TextError error = text->error({}, same, std::numeric_limits<double>::infinity());
        const CaseErrors errorsOf = [&](const std::vector<EvalCase>& some) {
            return text->errors(
                {}, {texelsWith(some, levels), exact->judged(texelsOfCases(some)).exact});
        };
        const ErrorClimb how{.hasOwnValues = cases.hasOwnValues};
        error.worst = std::max(error.worst, worstCases(errorsOf, common, how, isStopped).error);
        ways.push_back({levels, error, *cost});
    }
    return ways;
}

} // namespace patina
