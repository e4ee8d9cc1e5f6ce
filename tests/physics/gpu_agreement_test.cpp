// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "measure/eval_gpu.h"
#include "measure/eval_reference.h"
#include "random_cases.h"

namespace patina::physics {
namespace {

/// What the project promises: ordinary values agree to 1e-4 of themselves where they exceed 1e-4.
constexpr double relativeBound = 1e-4;
constexpr double smallestJudged = 1e-4;
constexpr int casesPerBlock = 100000;

/// One float rounding of a number near 1.
constexpr double floatRounding = 0x1p-24;

/// Of 100 000 cases, how many may be so close to a critical angle or the edge of a cone that a
/// rounding of their own input moves the exact answer visibly.
constexpr int mostUnsettled = 10;

/// The largest relative difference where it counts; infinite where a result is not finite.
double difference(const std::vector<double>& exact, const std::vector<double>& answer) {
    double worst = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        if (!std::isfinite(answer[i]) || !std::isfinite(exact[i])) {
            return HUGE_VAL;
        }
        if (std::abs(exact[i]) > smallestJudged) {
            worst = std::max(worst, std::abs(answer[i] / exact[i] - 1.0));
        }
    }
    return worst;
}

double movedBy(EvalCase request, double EvalCase::*number, const std::vector<double>& exact) {
    request.*number += floatRounding;
    return difference(exact, evaluatedInDouble(request).value());
}

double movedBy(EvalCase request, glm::dvec3 EvalCase::*vector, int component,
               const std::vector<double>& exact) {
    (request.*vector)[component] +=
        floatRounding * std::max(1.0, std::abs((request.*vector)[component]));
    return difference(exact, evaluatedInDouble(request).value());
}

/// Whether rounding the case's own inputs moves the exact answer by a good part of the bound.
bool isUnsettled(const EvalCase& request, const std::vector<double>& exact) {
    double moved = movedBy(request, &EvalCase::number, exact);
    for (int component = 0; component < 3; ++component) {
        moved += movedBy(request, &EvalCase::l, component, exact);
        moved += movedBy(request, &EvalCase::v, component, exact);
    }
    return moved > relativeBound / 8.0;
}

class GpuAgreement : public testing::TestWithParam<std::string> {};

TEST_P(GpuAgreement, RandomOrdinaryCases_MatchTheReference) {
    OrdinaryCases random(blockNamed(GetParam()));
    std::vector<EvalCase> cases;
    for (int i = 0; i < casesPerBlock; ++i) {
        cases.push_back(random.next());
    }
    EvalGpu gpu;
    const auto answers = gpu.evaluate(cases, catalog());
    ASSERT_TRUE(answers.front()) << answers.front().error().text();
    int differing = 0;
    int unsettled = 0;
    double worst = 0.0;
    std::string example;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        ASSERT_TRUE(answers[i]) << answers[i].error().text();
        const std::vector<double> exact = evaluatedInDouble(cases[i]).value();
        const double error = difference(exact, *answers[i]);
        if (error >= relativeBound && isUnsettled(cases[i], exact)) {
            ++unsettled;
            continue;
        }
        differing += error < relativeBound ? 0 : 1;
        if (error > worst) {
            worst = error;
            example = described(cases[i], exact, *answers[i]);
        }
    }
    RecordProperty("worst", std::to_string(worst));
    EXPECT_LE(unsettled, mostUnsettled);
    EXPECT_EQ(differing, 0) << "worst " << worst << " in " << example;
}

INSTANTIATE_TEST_SUITE_P(EveryBlock, GpuAgreement, testing::ValuesIn(blockNames()),
                         [](const auto& tested) { return testName(tested.param); });

} // namespace
} // namespace patina::physics
