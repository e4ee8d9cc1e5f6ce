// SPDX-License-Identifier: GPL-3.0-or-later
// All models on one scene.
#include "measure/model_ranking.h"

#include <algorithm>

#include "gpu_fixture.h"

namespace patina {
namespace {

class ModelRankingTest : public GpuTest {
  protected:
    std::vector<ModelCost> ranked() {
        const Scene scene = simpleScene();
        CostSweep::Options options;
        options.size = {16, 16};
        options.pairs.most = 7;
        auto ranking =
            ModelRanking::create({scene, 0, scene.camera, meshSource(), catalog}, options);
        EXPECT_TRUE(ranking);
        while (!(*ranking)->finished()) {
            (*ranking)->step();
        }
        EXPECT_EQ((*ranking)->problems(), Errors());
        EXPECT_GT((*ranking)->pixels(), 50u);
        return (*ranking)->costs();
    }
};

TEST_F(ModelRankingTest, EveryModel_IsRankedByItsTime) {
    const std::vector<ModelCost> costs = ranked();
    EXPECT_EQ(costs.size(), catalog->ofKind("models").size());
    EXPECT_TRUE(std::ranges::is_sorted(costs, {}, [](const ModelCost& each) {
        return each.cost.ratio.median;
    }));
    for (const ModelCost& each : costs) {
        EXPECT_GT(each.cost.nanosecondsPerPixel, 0.0) << each.model;
        EXPECT_TRUE(each.instructions) << each.model;
    }
}

TEST_F(ModelRankingTest, SceneWithoutObjects_IsAnError) {
    EXPECT_FALSE(ModelRanking::create({Scene(), 0, Camera(), meshSource(), catalog}, {}));
}

} // namespace
} // namespace patina
