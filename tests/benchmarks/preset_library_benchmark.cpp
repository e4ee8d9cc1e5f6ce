// SPDX-License-Identifier: GPL-3.0-or-later
// Five thousand presets in the editor's library.
#include <sstream>

#include "benchmarks.h"
#include "programs.h"
#include "statistics.h"
#include "support/program.h"

namespace patina::benchmarks {

bool presetLibrary() {
    const tests::Start start{
        .arguments = {"5000"}, .environment = {}, .input = {}, .timeLimitSeconds = 400.0};
    const tests::Outcome outcome = tests::run(program("patina-library-editor"), start);
    if (outcome.exitCode != 0) {
        report("5000 presets", outcome.err, false, "");
        return false;
    }
    bool kept = true;
    std::istringstream lines(outcome.out);
    double milliseconds = 0.0;
    double limit = 0.0;
    std::string what;
    while (lines >> milliseconds >> limit && std::getline(lines >> std::ws, what)) {
        const bool isKept = milliseconds <= limit;
        kept = kept && isKept;
        report("5000 presets: " + what, fmt::format("{:.3g} ms", milliseconds), isKept,
               fmt::format("<= {:.0f} ms", limit));
    }
    return kept;
}

} // namespace patina::benchmarks
