// SPDX-License-Identifier: GPL-3.0-or-later
// Models that draw marks: what the marks cover, in pixels of a picture and exactly.
#include <gtest/gtest.h>

#include <cmath>

#include "measure/eval/eval_reference.h"
#include "physics_cases.h"

namespace patina::physics::marks_test {
namespace {

/// A drawing of black ink on white paper whose tone runs over all of n.l.
EvalCase drawing(const std::string& model, const std::string& pattern) {
    EvalCase request;
    request.block.block = catalog().find("models", model);
    request.block.values = {{"diffuse.color", glm::dvec3(1.0)},
                            {"ink.color", glm::dvec3(0.0)},
                            {"angle", 0.0},
                            {"tone.light", 1.0},
                            {"tone.dark", 0.0}};
    if (!pattern.empty()) {
        request.block.values.emplace("pattern", pattern);
        request.block.values.emplace("cell", 8.0);
    }
    request.v = {0.0, 0.0, 1.0};
    return request;
}

void light(EvalCase& request, double nl) {
    request.l = {std::sqrt(1.0 - nl * nl), 0.0, nl};
}

/// The mean over a square of whole cells whose pixels are looked at 8 times in each direction.
double meanPaper(EvalCase request, double side) {
    constexpr int looks = 8;
    const int count = static_cast<int>(side) * looks;
    double sum = 0.0;
    for (int y = 0; y < count; ++y) {
        for (int x = 0; x < count; ++x) {
            request.pixel = {(x + 0.5) / looks, (y + 0.5) / looks};
            sum += evaluatedInDouble(request).value()[0];
        }
    }
    return sum / (count * count);
}

class HalftoneCoverage : public testing::TestWithParam<const char*> {};

TEST_P(HalftoneCoverage, MeanOfACell_IsTheTone) {
    EvalCase request = drawing("halftone", GetParam());
    for (const double nl : {0.02, 0.15, 0.3, 0.5, 0.7, 0.9, 0.99}) {
        light(request, nl);
        EXPECT_NEAR(meanPaper(request, 8.0), nl, 0.006) << "n.l " << nl;
    }
}

TEST_P(HalftoneCoverage, FullLight_LeavesThePaperBare) {
    EvalCase request = drawing("halftone", GetParam());
    light(request, 1.0);
    EXPECT_EQ(meanPaper(request, 8.0), 1.0);
}

INSTANTIATE_TEST_SUITE_P(EveryPattern, HalftoneCoverage,
                         testing::Values("dots", "lines", "cross"));

TEST(Hatching, LessLight_NeverLightensAPixel) {
    EvalCase request = drawing("hatching", {});
    for (int place = 0; place < 400; ++place) {
        request.pixel = {0.37 * place, 0.73 * place};
        double before = 1.0;
        for (int step = 24; step >= 0; --step) {
            light(request, step / 24.0);
            const double paper = evaluatedInDouble(request).value()[0];
            EXPECT_LE(paper, before) << "n.l " << step / 24.0 << ", pixel " << place;
            before = paper;
        }
    }
}

TEST(Hatching, FirstTone_DrawsTheFirstLayerOnly) {
    EvalCase request = drawing("hatching", {});
    request.block.values["wobble"] = Value(0.0);
    request.block.values["spacing"] = Value(12.0);
    light(request, 5.0 / 6.0);
    request.pixel = {100.0, 24.0};
    EXPECT_NEAR(evaluatedInDouble(request).value()[0], 0.0, 1e-9);
    request.pixel = {100.0, 30.0};
    EXPECT_EQ(evaluatedInDouble(request).value()[0], 1.0);
}

} // namespace
} // namespace patina::physics::marks_test
