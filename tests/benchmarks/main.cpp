// SPDX-License-Identifier: GPL-3.0-or-later
// patina-benchmarks [name...]: prints each figure with its spread and its target. Ratios come from
// interleaved runs on the same machine, so they mean something on any machine.
#include <cstdlib>
#include <string_view>
#include <vector>

#include "benchmarks.h"
#include "statistics.h"
#include "support/program.h"

int main(int count, char** arguments) {
    // What the editor remembers and keeps safe is not mixed with the user's own.
    const patina::tests::TemporaryFolder home;
    for (const char* name :
         {"XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"}) {
        setenv(name, (home / name).c_str(), 1);
    }
    struct Entry {
        std::string_view name;
        bool (*run)();
    };
    const std::vector<Entry> entries = {{"startup", patina::benchmarks::startup},
                                        {"idle", patina::benchmarks::idle},
                                        {"slider-tick", patina::benchmarks::sliderTick},
                                        {"dragging", patina::benchmarks::dragging},
                                        {"overlaid-lobes", patina::benchmarks::overlaidLobes},
                                        {"model-swap", patina::benchmarks::modelSwap},
                                        {"large-mesh", patina::benchmarks::largeMesh},
                                        {"mesh-loading", patina::benchmarks::meshLoading},
                                        {"preset-library", patina::benchmarks::presetLibrary},
                                        {"program-making", patina::benchmarks::programMaking},
                                        {"model-cost", patina::benchmarks::modelCost},
                                        {"accuracy-cost", patina::benchmarks::accuracyCost},
                                        {"style-cost", patina::benchmarks::styleCost},
                                        {"predicted-cost", patina::benchmarks::predictedCost},
                                        {"removed-effects", patina::benchmarks::removedEffects},
                                        {"found-fronts", patina::benchmarks::foundFronts},
                                        {"sweep-time", patina::benchmarks::sweepTime},
                                        {"front-twice", patina::benchmarks::frontTwice},
                                        {"fitted-light", patina::benchmarks::fittedLight},
                                        {"coherence", patina::benchmarks::coherence},
                                        {"contact-sheet", patina::benchmarks::contactSheet},
                                        {"many-objects", patina::benchmarks::manyObjects},
                                        {"views", patina::benchmarks::views},
                                        {"assembly", patina::benchmarks::assembly},
                                        {"switches", patina::benchmarks::switches},
                                        {"everything-on", patina::benchmarks::everythingOn},
                                        {"off-effects", patina::benchmarks::offEffects},
                                        {"assembly-count", patina::benchmarks::assemblyCount}};
    const std::vector<std::string_view> wanted(arguments + 1, arguments + count);
    bool kept = true;
    for (const Entry& entry : entries) {
        if (wanted.empty() || std::ranges::find(wanted, entry.name) != wanted.end()) {
            kept = entry.run() && kept;
        }
    }
    return kept ? 0 : 1;
}
