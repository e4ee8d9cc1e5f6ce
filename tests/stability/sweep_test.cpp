// SPDX-License-Identifier: GPL-3.0-or-later
// Every block of the catalogue in every edge case, in double precision and in the real shader.
#include <iostream>

#include <gtest/gtest.h>

#include "gl/headless_context.h"
#include "measure/stability/stability_sweep.h"
#include "measure/stability/sweep_cases.h"
#include "stability_cases.h"

namespace patina::stability::sweep_test {
namespace {

std::string described(const SweepReport& report) {
    std::string text = patina::text(report.errors);
    for (const auto& [key, tally] : report.defects) {
        text += std::to_string(tally.count) + (key.gpu ? " on the GPU: " : " on the CPU: ") +
                wordsFor(key.defect) + ", worst " + std::to_string(tally.worst.excess) + "\n  " +
                variantText(tally.worst.request) + "\n  " + evalJson(tally.worst.request).dump() +
                "\n  value";
        for (std::size_t i = 0; i < tally.worst.numbers; ++i) {
            text += ' ' + std::to_string(tally.worst.value[i]) + " (exact " +
                    std::to_string(tally.worst.exact[i]) + ')';
        }
        text += '\n';
    }
    return text;
}

/// A third of what the editor tries: the sweep of all blocks still has millions of cases.
StabilitySweep sweepOf(const Block& block) {
    SweepOptions options;
    options.shaders = catalog().roots.front().folder;
    options.cases = 100000;
    return {sweepVariants(catalog(), block), options};
}

class EveryHardCase : public testing::TestWithParam<const Block*> {};

TEST_P(EveryHardCase, OfABlock_IsFinitePositiveAndExact) {
    const auto context = gl::HeadlessContext::create();
    ASSERT_TRUE(context) << context.error().text();
    StabilitySweep sweep = sweepOf(*GetParam());
    while (!sweep.finished()) {
        sweep.step();
    }
    const SweepReport& report = sweep.report();
    std::cout << report.cases << " cases in " << report.programs << " programs, largest error "
              << report.largestError << " of its bound\n";
    EXPECT_TRUE(report.isClean()) << described(report);
    EXPECT_EQ(report.cases, sweepOf(*GetParam()).plannedCases());
}

TEST(StabilitySweep, OfAllBlocks_HasTwoMillionCases) {
    std::size_t cases = 0;
    for (const Block* block : evaluatedBlocks()) {
        cases += sweepOf(*block).plannedCases();
    }
    EXPECT_GE(cases, 2000000U);
}

INSTANTIATE_TEST_SUITE_P(EveryBlock, EveryHardCase, testing::ValuesIn(evaluatedBlocks()), nameOf);

} // namespace
} // namespace patina::stability::sweep_test
