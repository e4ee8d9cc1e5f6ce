// SPDX-License-Identifier: GPL-3.0-or-later
// What it saves that only the code for a scene is in its program: beside one that is told by
// uniforms what it is to do.
#include <cmath>
#include <cstdio>
#include <memory>

#include "assembled_program.h"
#include "benchmarks.h"
#include "statistics.h"
#include "switched_program.h"

namespace patina::benchmarks {
namespace {

/// With all models a pixel takes microseconds.
constexpr int stageSize = 256;
constexpr int rounds = 5;

bool isSame(const Image& a, const Image& b) {
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        if (!(std::abs(a.pixels[i] - b.pixels[i]) <= 1.0f / 255.0f)) {
            return false;
        }
    }
    return true;
}

/// There is no bound on the factor; the pictures must be the same.
bool compare(BallStage& stage, AssembledProgram& assembled, SwitchedProgram& switched,
             const std::string& name) {
    const auto useAssembled = [&assembled] { assembled.use(); };
    const auto useSwitched = [&switched] { switched.use(); };
    const bool same = isSame(stage.picture(useAssembled), stage.picture(useSwitched));
    std::vector<double> ratios;
    for (int round = 0; round < rounds; ++round) {
        const double own = stage.secondsPerFrame(useAssembled);
        ratios.push_back(stage.secondsPerFrame(useSwitched) / own);
    }
    report("Switched by uniforms / assembled: " + name, text(spreadOf(ratios), 1.0, "x"), same,
           "the same picture");
    std::fflush(stdout); // the next takes seconds to compile
    return same;
}

} // namespace

bool switches() {
    BallStage stage(stageSize);
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    const Scene scene = plainScene(*catalog);
    AssembledProgram assembled(catalog, scene, stage);
    SwitchedProgram one(*catalog, {catalog->find("models", "phong")}, scene, stage);
    bool kept = compare(stage, assembled, one, "all effects, one model");
    SwitchedProgram all(*catalog, modelsByFormula(*catalog), scene, stage);
    kept = compare(stage, assembled, all, "all effects, all models") && kept;
    return kept;
}

} // namespace patina::benchmarks
