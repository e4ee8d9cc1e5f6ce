// SPDX-License-Identifier: GPL-3.0-or-later
// What editors of their own measure and print: a move of a dragged slider, and a tick beside the
// dock Lobe, both on the window's thread and without the driver.
#include <sstream>

#include "benchmarks.h"
#include "programs.h"
#include "statistics.h"
#include "support/program.h"

namespace patina::benchmarks {
namespace {

/// Runs an editor without the driver and reports its lines "figure limit unit what".
bool reportPrinted(const std::string& title, const char* editor) {
    const tests::Start start{.arguments = {},
                             .environment = {{"GALLIUM_NOOP", "1"}},
                             .input = {},
                             .timeLimitSeconds = 900.0};
    const tests::Outcome outcome = tests::run(program(editor), start);
    if (outcome.exitCode != 0) {
        report(title, outcome.err, false, "");
        return false;
    }
    bool kept = true;
    std::istringstream lines(outcome.out);
    double figure = 0.0;
    double limit = 0.0;
    std::string unit;
    std::string what;
    while (lines >> figure >> limit >> unit && std::getline(lines >> std::ws, what)) {
        const bool isKept = figure <= limit;
        kept = kept && isKept;
        report(title + ": " + what, fmt::format("{:.3g} {}", figure, unit), isKept,
               fmt::format("<= {} {}", limit, unit));
    }
    return kept;
}

} // namespace

bool dragging() {
    return reportPrinted("Dragging", "patina-dragging-editor");
}

bool overlaidLobes() {
    return reportPrinted("Four overlaid", "patina-lobe-editor");
}

} // namespace patina::benchmarks
