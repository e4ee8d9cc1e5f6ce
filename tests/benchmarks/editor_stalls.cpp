// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor_stalls.h"

#include <map>
#include <sstream>
#include <vector>

#include "programs.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

constexpr double maxMs = 100.0;

/// What a step did in each run, in milliseconds.
struct Step {
    std::vector<double> gaps;
    std::vector<double> times;
};

/// Adds the lines "gap time name" that the editor printed; `order` gets the names that are new.
void addSteps(const std::string& printed, std::map<std::string, Step>& steps,
              std::vector<std::string>& order) {
    std::istringstream lines(printed);
    double gap = 0.0;
    double time = 0.0;
    std::string name;
    while (lines >> gap >> time && std::getline(lines >> std::ws, name)) {
        if (!steps.contains(name)) {
            order.push_back(name);
        }
        steps[name].gaps.push_back(gap);
        steps[name].times.push_back(time);
    }
}

} // namespace

bool reportStalls(const char* editor, const tests::Start& start, int runs) {
    std::map<std::string, Step> steps;
    std::vector<std::string> order;
    for (int run = 0; run < runs; ++run) {
        const tests::Outcome outcome = tests::run(program(editor), start);
        if (outcome.exitCode != 0) {
            report(editor, outcome.err, false, "");
            return false;
        }
        addSteps(outcome.out, steps, order);
    }
    bool kept = true;
    for (const std::string& name : order) {
        const Spread gap = spreadOf(steps[name].gaps);
        kept = kept && gap.median <= maxMs;
        report("Longest stall, " + name, text(gap, 1.0, "ms"), gap.median <= maxMs, "<= 100 ms");
        report("  until it is on the screen", text(spreadOf(steps[name].times), 1.0, "ms"), true,
               "");
    }
    return kept;
}

} // namespace patina::benchmarks
