// SPDX-License-Identifier: GPL-3.0-or-later
// Picture passes, fur and strokes have their accuracy choices on charts, like all else.
#include <algorithm>

#include "gpu_fixture.h"
#include "measure/choice/choices.h"
#include "measure/cost/cost_sweep.h"

namespace patina::pass_accuracy_test {
namespace {

class PassAccuracyTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    Scene withPasses(const std::vector<std::string>& ids) const {
        Scene scene = simpleScene();
        for (const std::string& id : ids) {
            scene.passes.push_back(block("pass", id));
        }
        return scene;
    }

    std::vector<std::string> passChoices(const Scene& scene) const {
        std::vector<std::string> ids;
        for (const Choice& choice : choicesOfPicture(scene, *catalog)) {
            if (choice.id.starts_with("pass.")) {
                ids.push_back(choice.id);
            }
        }
        return ids;
    }

    std::unique_ptr<CostSweep> swept(const Scene& scene, CostSweep::Options options) {
        options.size = {32, 32};
        options.pairs.max = 3;
        options.combinations = false;
        auto sweep = CostSweep::create({scene, 0, scene.camera, meshSource(), catalog}, options);
        EXPECT_TRUE(sweep);
        while (!(*sweep)->finished()) {
            (*sweep)->step(std::chrono::milliseconds(50));
        }
        EXPECT_EQ((*sweep)->problems(), Errors());
        return std::move(*sweep);
    }
};

TEST_F(PassAccuracyTest, ChoicesOfPasses_AreListedOnceAndFromTheExactLevelOn) {
    EXPECT_EQ(passChoices(simpleScene()), std::vector<std::string>());
    const Scene scene = withPasses({"kuwahara", "kuwahara", "watercolour"});
    EXPECT_EQ(passChoices(scene),
              (std::vector<std::string>{"pass.kuwahara.sectors", "pass.kuwahara.samples",
                                        "pass.watercolour.samples"}));
    const std::vector<Choice> choices = choicesOfPicture(scene, *catalog);
    const auto samples = std::ranges::find(choices, "pass.kuwahara.samples", &Choice::id);
    ASSERT_NE(samples, choices.end());
    EXPECT_EQ(samples->levels.front().id, "fine");
    EXPECT_EQ(samples->levels.back().id, "coarse");
}

TEST_F(PassAccuracyTest, PassesThatDoNothing_AndChoicesThatDoNotCount_AreLeftOut) {
    Scene scene = withPasses({"kuwahara", "dither"});
    scene.passes[0].parameters["radius"] = 0.0;
    EXPECT_EQ(passChoices(scene), std::vector<std::string>());
    scene.passes[1].parameters["pattern"] = std::string("diffused");
    EXPECT_EQ(passChoices(scene), std::vector<std::string>{"pass.dither.run"});
}

TEST_F(PassAccuracyTest, LevelOfAPass_IsThatOfAllPassesOfItsBlock) {
    const Scene scene = withPasses({"kuwahara", "watercolour", "kuwahara"});
    const std::vector<Choice> choices = choicesOfPicture(scene, *catalog);
    EXPECT_EQ(levelsOfPicture(scene, choices, *catalog).at("pass.kuwahara.samples"), "normal");
    ChosenFrame frame{scene, View()};
    choose(frame, 0, choices, {{"pass.kuwahara.samples", "coarse"}}, *catalog);
    for (const std::size_t i : {0u, 2u}) {
        EXPECT_EQ(std::get<std::string>(frame.scene.passes[i].parameters.at("samples")), "coarse");
    }
    EXPECT_EQ(std::get<std::string>(frame.scene.passes[1].parameters.at("samples")), "fine");
    choose(frame, 0, choices, {}, *catalog);
    EXPECT_FALSE(levelsOfPicture(frame.scene, choices, *catalog).contains("pass.kuwahara.samples"));
    frame.scene.passes[2].parameters["samples"] = std::string("coarse");
    EXPECT_EQ(levelsOfPicture(frame.scene, choices, *catalog).at("pass.kuwahara.samples"),
              "coarse");
}

TEST_F(PassAccuracyTest, ErrorOfAPass_IsThatOfTheFinishedPicture) {
    Scene scene = withPasses({"kuwahara"});
    scene.passes[0].parameters["radius"] = 40.0;
    CostSweep::Options options;
    options.scope = Choice::Scope::Picture;
    options.only = {"pass.kuwahara.sectors", "pass.kuwahara.samples"};
    const auto sweep = swept(scene, options);
    const CostChart& chart = sweep->chart();
    ASSERT_NE(chart.find({}), nullptr);
    EXPECT_EQ(chart.find({})->error.max, 0.0);
    EXPECT_NE(chart.groundTruth.find("finished picture"), std::string::npos) << chart.groundTruth;
    const CostPoint* coarse = chart.find({{"pass.kuwahara.samples", "coarse"}});
    ASSERT_NE(coarse, nullptr);
    EXPECT_GT(coarse->error.mean, 0.0);
    EXPECT_GE(coarse->error.shown, 1.0 / 255.0);
    EXPECT_GT(coarse->cost.runs, 0);
    const std::vector<double> finest = sweep->errorMap({{"pass.kuwahara.samples", "fine"}});
    ASSERT_EQ(finest.size(), 32u * 32u);
    EXPECT_EQ(std::ranges::max(finest), 0.0);
}

TEST_F(PassAccuracyTest, LayersOfFur_AreOnTheChartOfTheMaterial) {
    Scene scene = simpleScene();
    EXPECT_EQ(std::ranges::count(materialChoices(scene, 0, *catalog), "shells.layers", &Choice::id),
              0);
    setPart(scene.objects[0].material.parts, kinds::shells, block("shells", "fur"));
    CostSweep::Options options;
    options.only = {"shells.layers"};
    const auto sweep = swept(scene, options);
    const CostChart& chart = sweep->chart();
    ASSERT_NE(chart.find({}), nullptr);
    EXPECT_EQ(chart.find({})->error.max, 0.0);
    const CostPoint* coarse = chart.find({{"shells.layers", "8"}});
    const CostPoint* fine = chart.find({{"shells.layers", "48"}});
    ASSERT_TRUE(coarse != nullptr && fine != nullptr);
    // The mean of the pixels' errors does not fall evenly with the layers: hairs move, and few of
    // them err by all of their light. How different the pictures look does.
    EXPECT_GT(coarse->error.flip, fine->error.flip);
}

TEST_F(PassAccuracyTest, MarksOfStrokes_AreOnTheChartOfTheMaterial) {
    Scene scene = simpleScene();
    setPart(scene.objects[0].material.parts, kinds::strokes, block("strokes", "brush"));
    CostSweep::Options options;
    options.only = {"strokes.marks"};
    const auto sweep = swept(scene, options);
    const CostChart& chart = sweep->chart();
    ASSERT_NE(chart.find({}), nullptr);
    EXPECT_EQ(chart.find({})->error.max, 0.0);
    const CostPoint* coarse = chart.find({{"strokes.marks", "10"}});
    ASSERT_NE(coarse, nullptr);
    EXPECT_GT(coarse->error.mean, 0.0);
}

} // namespace
} // namespace patina::pass_accuracy_test
