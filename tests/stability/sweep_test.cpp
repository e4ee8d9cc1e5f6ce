// SPDX-License-Identifier: GPL-3.0-or-later
// Every block of the catalogue at every hard case, in double precision and in the real shader.
#include <iostream>

#include <gtest/gtest.h>

#include "gl/headless_context.h"
#include "measure/stability_sweep.h"
#include "measure/sweep_cases.h"
#include "stability_cases.h"

namespace patina::stability {
namespace {

std::string described(const SweepReport& report) {
    std::string text = patina::text(report.errors);
    for (const auto& [key, tally] : report.defects) {
        text += std::to_string(tally.count) + (key.first ? " on the GPU: " : " on the CPU: ") +
                wordsFor(key.second) + ", worst " + std::to_string(tally.worst.excess) + "\n  " +
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

/// What the sweep of one block found; swept once for all tests.
const SweepReport& swept(const Block& block) {
    static std::map<const Block*, SweepReport> reports;
    const auto found = reports.find(&block);
    if (found != reports.end()) {
        return found->second;
    }
    const auto context = gl::HeadlessContext::create();
    EXPECT_TRUE(context) << (context ? "" : context.error().text());
    SweepOptions options;
    options.shaders = catalog().roots.front().folder;
    StabilitySweep sweep(sweepVariants(catalog(), block), options);
    while (!sweep.finished()) {
        sweep.step();
    }
    return reports.emplace(&block, sweep.report()).first->second;
}

class EveryHardCase : public testing::TestWithParam<const Block*> {};

TEST_P(EveryHardCase, OfABlock_IsFinitePositiveAndExact) {
    const SweepReport& report = swept(*GetParam());
    std::cout << report.cases << " cases in " << report.programs << " programs, largest error "
              << report.largestError << " of its bound\n";
    EXPECT_TRUE(report.sound()) << described(report);
}

TEST(StabilitySweep, OfAllBlocks_HasTwoMillionCases) {
    std::size_t cases = 0;
    for (const Block* block : evaluatedBlocks()) {
        cases += swept(*block).cases;
    }
    EXPECT_GE(cases, 2000000U);
}

INSTANTIATE_TEST_SUITE_P(EveryBlock, EveryHardCase, testing::ValuesIn(evaluatedBlocks()), nameOf);

} // namespace
} // namespace patina::stability
