// SPDX-License-Identifier: GPL-3.0-or-later
// What four views of one context cost beside one of them.
#include <array>
#include <span>

#include "benchmarks.h"
#include "stage.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

constexpr int rounds = 41;
constexpr double most = 4.1;

/// Seconds of a frame of each of these views, in which the camera has moved.
double frameSeconds(Stage& stage, std::span<const std::unique_ptr<Renderer>> views, int round) {
    stage.view.camera.yaw = 0.5 * round;
    const double began = wallSeconds();
    for (const auto& view : views) {
        stage.drawWith(*view);
    }
    glFinish();
    return wallSeconds() - began;
}

} // namespace

bool views() {
    Stage stage({640, 400});
    stage.use("phong");
    std::array<std::unique_ptr<Renderer>, 4> all;
    all.front() = Stage::rendererOf(stage.sharedCatalog());
    for (std::size_t i = 1; i < all.size(); ++i) {
        all[i] = all.front()->forAnotherView();
    }
    std::vector<double> ofOne;
    std::vector<double> ratios;
    for (int round = -2; round < rounds; ++round) { // the first ones make programs and memory
        const double one = frameSeconds(stage, std::span(all).first(1), round);
        const double four = frameSeconds(stage, all, round + rounds);
        if (round >= 0) {
            ofOne.push_back(one);
            ratios.push_back(four / one);
        }
    }
    const Spread ratio = spreadOf(ratios);
    report("Frame of one view", text(spreadOf(ofOne), 1e3, "ms"), true, "");
    report("Four views / one", text(ratio, 1.0, "x"), ratio.median <= most, "<= 4.1");
    return ratio.median <= most;
}

} // namespace patina::benchmarks
