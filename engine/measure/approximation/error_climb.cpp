// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/error_climb.h"

#include <algorithm>

#include "measure/approximation/approximation_cases.h"

namespace patina {
namespace {

/// Is a case with its error.
struct Climber {
    EvalCase at;
    double error = 0.0;
};

std::vector<Climber> judgedOf(const CaseErrors& errorsOf, std::vector<EvalCase> cases) {
    const std::vector<double> errors = errorsOf(cases);
    std::vector<Climber> climbers;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        climbers.push_back({std::move(cases[i]), errors[i]});
    }
    return climbers;
}

/// Keeps the worst of each of several parts, of which none has more of one place than another.
std::vector<Climber> worstOfParts(std::vector<Climber> all, std::size_t parts) {
    std::vector<Climber> kept;
    parts = std::min(parts, all.size());
    for (std::size_t i = 0; i < parts; ++i) {
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(i * all.size() / parts);
        const auto end = all.begin() + static_cast<std::ptrdiff_t>((i + 1) * all.size() / parts);
        kept.push_back(std::move(*std::max_element(
            begin, end, [](const Climber& a, const Climber& b) { return a.error < b.error; })));
    }
    return kept;
}

} // namespace

WorstCases worstCases(const CaseErrors& errorsOf, const std::vector<EvalCase>& from,
                      const ErrorClimb& how, const std::function<bool()>& isStopped) {
    std::vector<Climber> climbers = worstOfParts(judgedOf(errorsOf, from), how.climbers);
    for (std::size_t round = 0; round < how.rounds && !isStopped(); ++round) {
        std::vector<EvalCase> places;
        for (std::size_t i = 0; i < climbers.size(); ++i) {
            const auto seed = static_cast<std::uint32_t>(round * climbers.size() + i);
            const auto some = nearbyCases(climbers[i].at, how.tries, how.hasOwnValues, seed);
            places.insert(places.end(), some.begin(), some.end());
        }
        const std::vector<Climber> tried = judgedOf(errorsOf, std::move(places));
        for (std::size_t i = 0; i < tried.size(); ++i) {
            Climber& climber = climbers[i / how.tries];
            if (tried[i].error > climber.error) {
                climber = tried[i];
            }
        }
    }
    WorstCases worst;
    for (Climber& climber : climbers) {
        worst.error = std::max(worst.error, climber.error);
        worst.cases.push_back(std::move(climber.at));
    }
    return worst;
}

} // namespace patina
