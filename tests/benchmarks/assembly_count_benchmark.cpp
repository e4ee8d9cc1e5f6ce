// SPDX-License-Identifier: GPL-3.0-or-later
// What putting programs together from blocks costs beside those written by hand, in instructions,
// which no load moves.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "assembled_program.h"
#include "assembly_scenes.h"
#include "benchmarks.h"
#include "fragment_code.h"
#include "minimal_program.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

constexpr int pixels = 64; ///< of the stage's edge: each program is compiled by its first frame

/// The ratios of the models in one surrounding.
struct Row {
    std::vector<double> ratios;
    std::string beyond; ///< the models that are
};

std::string rangeOf(const Row& row) {
    const auto [smallest, largest] = std::ranges::minmax(row.ratios);
    const std::string range = fmt::format("{:.3f} .. {:.3f}", smallest, largest);
    return row.beyond.empty() ? range : range + ";" + row.beyond;
}

} // namespace

bool assemblyCount() {
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1); // what lies there is not compiled
    BallStage stage(pixels);
    const auto code = FragmentCode::create();
    if (!code) {
        fmt::print("Instructions are not counted: {}\n", code.error().text());
        return true;
    }
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    const auto countOf = [&](const BallStage::Use& use) {
        return double(code->instructionsOf([&] { stage.secondsPerFrame(use); }));
    };
    std::map<std::string, Row> rows;
    std::vector<double> all;
    for (const std::string model : minimalModels) {
        for (const std::string& surrounding : surroundingsOf(*catalog, model)) {
            const Scene scene = sceneOf(*catalog, model, surrounding);
            AssembledProgram assembled(catalog, scene, stage);
            MinimalProgram minimal(*catalog, model, surrounding, scene, stage);
            const double ratio =
                countOf([&] { assembled.use(); }) / countOf([&] { minimal.use(); });
            Row& row = rows[surrounding];
            row.ratios.push_back(ratio);
            if (!(ratio <= maxAssembled)) {
                row.beyond += fmt::format(" {} {:.3f}", model, ratio);
            }
            all.push_back(ratio);
        }
    }
    for (const auto& [surrounding, row] : rows) {
        report("Instructions, assembled / by hand: " + surrounding, rangeOf(row),
               row.beyond.empty(), "<= 1.05");
    }
    const auto within =
        std::ranges::count_if(all, [](double ratio) { return ratio <= maxAssembled; });
    const double middle = spreadOf(all).median;
    report(fmt::format("{} combinations", all.size()),
           fmt::format("{} within; median {:.3f}", within, middle),
           std::size_t(within) == all.size() && middle <= maxAssembledMedian,
           "<= 1.05; median <= 1.02");
    return std::size_t(within) == all.size() && middle <= maxAssembledMedian;
}

} // namespace patina::benchmarks
