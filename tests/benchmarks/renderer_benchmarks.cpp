// SPDX-License-Identifier: GPL-3.0-or-later
// What an edit costs in the renderer: a slider's tick, and another model.
#include <ctime>

#include "allocations.h"
#include "benchmarks.h"
#include "stage.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

constexpr int ticks = 2000;

double threadSeconds() {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

} // namespace

bool sliderTick() {
    // One pixel: a software renderer would otherwise draw on our own clock.
    Stage stage({1, 1});
    stage.use("phong");
    stage.set("shininess", 10.0);
    stage.draw();
    std::vector<double> changed;
    std::vector<double> unchanged;
    changed.reserve(ticks); // what the benchmark itself keeps is not counted
    unchanged.reserve(ticks);
    long allocated = 0;
    int compiled = 0;
    for (int tick = 0; tick < ticks; ++tick) {
        stage.set("shininess", 10.0 + 0.1 * tick);
        const long before = allocations();
        const double began = threadSeconds();
        const FrameReport& frame = stage.draw();
        changed.push_back(threadSeconds() - began);
        allocated += allocations() - before;
        compiled += frame.compiled;
        const double again = threadSeconds();
        stage.draw();
        unchanged.push_back(threadSeconds() - again);
    }
    // The rest of a frame is the driver's: what it costs when nothing changed is taken off.
    std::vector<double> own;
    for (std::size_t i = 0; i < changed.size(); ++i) {
        own.push_back(changed[i] - unchanged[i]);
    }
    const Spread tick = spreadOf(own);
    report("Slider tick: our own CPU time", text(tick, 1e3, "ms"), tick.median <= 0.5e-3,
           "<= 0.5 ms");
    report("Frame without a change, of one pixel", text(spreadOf(unchanged), 1e3, "ms"), true, "");
    report("Slider tick: allocations per tick", fmt::format("{:.2f}", double(allocated) / ticks),
           allocated == 0, "0");
    report("Slider tick: programs compiled", std::to_string(compiled), compiled == 0, "0");
    return tick.median <= 0.5e-3 && allocated == 0 && compiled == 0;
}

bool modelSwap() {
    Stage stage({800, 600});
    const std::vector<const char*> models = {"lambert", "phong", "blinn-phong", "cook-torrance",
                                             "strauss"};
    stage.frameSeconds();
    std::vector<double> first;
    std::vector<double> second;
    std::vector<double> plain;
    for (const char* model : models) {
        stage.use(model);
        first.push_back(stage.frameSeconds());
        report(fmt::format("Model swap, first time: {}", model),
               fmt::format("{:.3g} ms", first.back() * 1e3), true, "");
    }
    for (int round = 0; round < 3; ++round) {
        for (const char* model : models) {
            stage.use(model);
            second.push_back(stage.frameSeconds());
            plain.push_back(stage.frameSeconds());
        }
    }
    const double slowest = *std::ranges::max_element(first);
    const double extra = spreadOf(second).median - spreadOf(plain).median;
    report("Model swap, first time: slowest of five", fmt::format("{:.3g} ms", slowest * 1e3),
           slowest <= 0.2, "<= 200 ms");
    report("Model swap, again: frame", text(spreadOf(second), 1e3, "ms"), true, "");
    report("Model swap, again: more than a plain frame", fmt::format("{:.3g} ms", extra * 1e3),
           extra <= 0.01, "<= 10 ms");
    return slowest <= 0.2 && extra <= 0.01;
}

} // namespace patina::benchmarks
