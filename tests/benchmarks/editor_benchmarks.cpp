// SPDX-License-Identifier: GPL-3.0-or-later
// What the running editor costs: its start, its memory, and doing nothing.
#include <chrono>
#include <thread>

#include "benchmarks.h"
#include "observed_program.h"
#include "programs.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

constexpr int startRuns = 9;
constexpr double idleSeconds = 10.0;
constexpr double maxSettleSeconds = 120.0;

void waitFor(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

/// Waits for what start-up leaves for later, on the first start pictures of presets: until the
/// program has done nothing for a second and a half.
bool settles(const ObservedProgram& program) {
    constexpr double patience = 1.5;
    for (double waited = 0.0; waited < maxSettleSeconds; waited += patience) {
        const long before = program.cpuTicks();
        waitFor(patience);
        if (program.cpuTicks() == before) {
            return true;
        }
    }
    return false;
}

/// Start time and memory of the editor over those of the empty window, run by run.
struct StartRatios {
    std::vector<double> editorSeconds; ///< to the first shaded picture
    std::vector<double> wholeSeconds;  ///< to the frame with all its pixels and samples
    std::vector<double> emptySeconds;
    std::vector<double> time;
    std::vector<double> memory;
};

bool addRun(StartRatios& ratios) {
    ObservedProgram empty(program("patina-empty-window"));
    const double emptySeconds = empty.secondsToFirstFrame();
    waitFor(0.5);
    const double emptyMegabytes = empty.residentMegabytes();

    ObservedProgram editor(program("patina"));
    const double editorSeconds = editor.secondsToFirstPicture();
    const double wholeSeconds = editor.secondsToFirstFrame();
    waitFor(0.5);
    if (emptySeconds < 0.0 || editorSeconds < 0.0 || wholeSeconds < 0.0) {
        return false;
    }
    ratios.emptySeconds.push_back(emptySeconds);
    ratios.editorSeconds.push_back(editorSeconds);
    ratios.wholeSeconds.push_back(wholeSeconds);
    ratios.time.push_back(editorSeconds / emptySeconds);
    ratios.memory.push_back(editor.residentMegabytes() / emptyMegabytes);
    return true;
}

/// A start that is left alone until programs and thumbnails lie on the disk.
void fillCaches() {
    ObservedProgram editor(program("patina"));
    editor.secondsToFirstFrame();
    settles(editor);
}

} // namespace

bool startup() {
    fillCaches();
    StartRatios ratios;
    for (int run = 0; run < startRuns; ++run) {
        if (!addRun(ratios)) {
            report("Start", "no first frame seen (is there a display?)", false, "");
            return false;
        }
    }
    const Spread time = spreadOf(ratios.time);
    const Spread memory = spreadOf(ratios.memory);
    report("Start: editor", text(spreadOf(ratios.editorSeconds), 1e3, "ms"), true, "");
    report("Start: editor, the whole frame", text(spreadOf(ratios.wholeSeconds), 1e3, "ms"), true,
           "");
    report("Start: empty window", text(spreadOf(ratios.emptySeconds), 1e3, "ms"), true, "");
    report("Start: editor / empty window", text(time, 1.0, "x"), time.median <= 3.0, "<= 3");
    report("Resident memory: editor / empty window", text(memory, 1.0, "x"), memory.median <= 1.35,
           "<= 1.35");
    return time.median <= 3.0 && memory.median <= 1.35;
}

bool idle() {
    ObservedProgram editor(program("patina"));
    if (editor.secondsToFirstFrame() < 0.0) {
        report("Idle", "no first frame seen (is there a display?)", false, "");
        return false;
    }
    if (!settles(editor)) {
        report("Idle", "still at work two minutes after the start", false, "");
        return false;
    }
    const long before = editor.cpuTicks();
    waitFor(idleSeconds);
    const long ticks = editor.cpuTicks() - before;
    // A frame would cost more than two ticks with a software renderer, so this counts frames too.
    report("Idle for 10 s: CPU ticks", std::to_string(ticks), ticks <= 2, "<= 2");
    return ticks <= 2;
}

} // namespace patina::benchmarks
