// SPDX-License-Identifier: GPL-3.0-or-later
// All models on one scene.
#include "measure/cost/model_ranking.h"

#include <algorithm>
#include <array>

#include "gpu_fixture.h"
#include "measure/cost/ranking_table.h"
#include "support/program.h"

namespace patina::model_ranking_test {
namespace {

class ModelRankingTest : public GpuTest {
  protected:
    std::vector<ModelCost> ranked() {
        const Scene scene = simpleScene();
        CostSweep::Options options;
        options.size = {16, 16};
        options.pairs.max = 7;
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
    EXPECT_TRUE(std::ranges::is_sorted(
        costs, {}, [](const ModelCost& each) { return each.cost.ratio.median; }));
    EXPECT_EQ(costs.front().cost.ratio.median, 1.0); // beside the quickest
    for (const ModelCost& each : costs) {
        EXPECT_GT(each.cost.nanosecondsPerPixel, 0.0) << each.model;
        EXPECT_TRUE(each.instructions) << each.model;
        EXPECT_TRUE(each.albedoLoss) << each.model;
    }
}

TEST_F(ModelRankingTest, GivenMaterials_AreRankedInsteadOfAllModels) {
    const Scene scene = simpleScene();
    CostSweep::Options options;
    options.size = {16, 16};
    options.pairs.max = 7;
    std::vector<Material> materials;
    for (const char* id : {"he-torrance", "lambert"}) {
        materials.push_back(defaultMaterial(*catalog->find("models", id)));
    }
    auto ranking =
        ModelRanking::create({scene, 0, scene.camera, meshSource(), catalog}, options, materials);
    ASSERT_TRUE(ranking);
    while (!(*ranking)->finished()) {
        (*ranking)->step();
    }
    const std::vector<ModelCost> costs = (*ranking)->costs();
    ASSERT_EQ(costs.size(), 2u);
    EXPECT_EQ(costs.front().model, "lambert");
    EXPECT_EQ(costs.back().model, "he-torrance");
}

TEST_F(ModelRankingTest, ModelThatDoesNotCompile_IsLeftOutAndTold) {
    const tests::TemporaryFolder folder;
    tests::writeFile(folder / "models/broken.json", R"({
        "id": "broken", "version": 1, "label": "Broken", "summary": "A test.",
        "applications": "None.", "source": "None.", "parameters": [],
        "claims": ["finite", "non_negative"]})");
    tests::writeFile(folder / "models/broken.glsl",
                     "// SPDX-License-"
                     "Identifier: MIT-0\n#include \"lib/directions.glsl\"\n"
                     "vec3 broken(Directions d, Broken p) {\n    return nothing;\n}\n");
    const std::array roots{BlockRoot{PATINA_SOURCE_DIR "/shaders", true},
                           BlockRoot{folder.path(), false}};
    const auto extended = std::make_shared<const Catalog>(loadCatalog(roots));
    const Scene scene = simpleScene();
    CostSweep::Options options;
    options.size = {16, 16};
    options.pairs.max = 7;
    std::vector<Material> materials;
    for (const char* id : {"broken", "lambert", "phong"}) {
        materials.push_back(defaultMaterial(*extended->find("models", id)));
    }
    auto ranking =
        ModelRanking::create({scene, 0, scene.camera, meshSource(), extended}, options, materials);
    ASSERT_TRUE(ranking);
    while (!(*ranking)->finished()) {
        (*ranking)->step();
    }
    EXPECT_EQ((*ranking)->costs().size(), 2u);
    ASSERT_FALSE((*ranking)->problems().empty());
    EXPECT_TRUE((*ranking)->problems().front().file.ends_with("broken.glsl"));
}

TEST(RankingTable, Lines_HaveTheLossOfLight) {
    ModelCost matte{"matte", "Matte", {}, std::nullopt, 0.25};
    ModelCost own{"own", "Own", {}, std::nullopt, std::nullopt};
    const std::string text = rankingText({matte, own});
    EXPECT_NE(text.find("25.0 %"), std::string::npos) << text;
    EXPECT_NE(rankingCsv({matte, own}).find(",0.25\nown,"), std::string::npos);
    EXPECT_TRUE(rankingJson({matte, own}).at(1).at("albedoLoss").is_null());
}

TEST(RankingTable, QuotationMarks_AreDoubled) {
    const ModelCost odd{"odd", "My \"odd\" model", {}, std::nullopt, std::nullopt};
    EXPECT_NE(rankingCsv({odd}).find("odd,\"My \"\"odd\"\" model\","), std::string::npos);
}

TEST_F(ModelRankingTest, ShortOfTime_MeasuresAsFewPairsAsAnIntervalNeeds) {
    const Scene scene = simpleScene();
    CostSweep::Options options;
    options.size = {16, 16};
    options.seconds = 1e-6;
    auto ranking = ModelRanking::create({scene, 0, scene.camera, meshSource(), catalog}, options);
    ASSERT_TRUE(ranking);
    double before = -1.0;
    while (!(*ranking)->finished()) {
        (*ranking)->step();
        const double progress = (*ranking)->progress();
        EXPECT_GE(progress, before);
        before = progress;
    }
    for (const ModelCost& each : (*ranking)->costs()) {
        EXPECT_EQ(each.cost.runs, options.pairs.min) << each.model;
    }
}

TEST_F(ModelRankingTest, SceneWithoutObjects_IsAnError) {
    EXPECT_FALSE(ModelRanking::create({Scene(), 0, Camera(), meshSource(), catalog}, {}));
}

} // namespace
} // namespace patina::model_ranking_test
