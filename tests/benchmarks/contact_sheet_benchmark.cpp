// SPDX-License-Identifier: GPL-3.0-or-later
// A contact sheet of 8 x 8 cells of 128 pixels, from a preset to a PNG file.
#include "benchmarks.h"
#include "programs.h"
#include "statistics.h"
#include "support/program.h"

namespace patina::benchmarks {
namespace {

constexpr int runs = 5;
constexpr double maxSeconds = 3.0;

} // namespace

bool contactSheet() {
    const tests::TemporaryFolder folder;
    const tests::Start start{
        .arguments = {"sheet", PATINA_SOURCE_DIR "/presets/strauss/realistic-metal.patina.json",
                      "--x", "metalness=0:1:8", "--y", "smoothness=0:1:8", "--no-control", "-o",
                      folder / "sheet.png"},
        .environment = {},
        .input = {}};
    std::vector<double> seconds;
    for (int run = 0; run <= runs; ++run) {
        const tests::Outcome outcome = tests::run(program("patina"), start);
        if (outcome.exitCode != 0) {
            report("Sheet of 64 cells", outcome.err, false, "");
            return false;
        }
        if (run > 0) { // the first one makes the program
            seconds.push_back(outcome.seconds);
        }
    }
    const Spread spread = spreadOf(seconds);
    const bool isKept = spread.median <= maxSeconds;
    report("Sheet of 64 cells", text(spread, 1.0, "s"), isKept, "<= 3 s");
    return isKept;
}

} // namespace patina::benchmarks
