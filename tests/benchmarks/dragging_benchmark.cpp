// SPDX-License-Identifier: GPL-3.0-or-later
// What a move of a dragged slider costs the window's thread, without the driver.
#include <sstream>

#include "benchmarks.h"
#include "programs.h"
#include "statistics.h"
#include "support/program.h"

namespace patina::benchmarks {

bool dragging() {
    const tests::Start start{.arguments = {},
                             .environment = {{"GALLIUM_NOOP", "1"}},
                             .input = {},
                             .timeLimitSeconds = 300.0};
    const tests::Outcome outcome = tests::run(program("patina-dragging-editor"), start);
    if (outcome.exitCode != 0) {
        report("Dragging", outcome.err, false, "");
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
        report("Dragging: " + what, fmt::format("{:.3g} {}", figure, unit), isKept,
               fmt::format("<= {} {}", limit, unit));
    }
    return kept;
}

} // namespace patina::benchmarks
