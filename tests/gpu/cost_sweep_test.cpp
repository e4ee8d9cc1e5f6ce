// SPDX-License-Identifier: GPL-3.0-or-later
// The instrument is calibrated: a model whose work and whose errors are known.
#include "measure/cost/cost_sweep.h"

#include <cmath>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "gpu_fixture.h"
#include "material/block_values.h"
#include "support/program.h"

namespace patina::cost_sweep_test {
namespace {

class CostSweepTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        tests::writeFile(folder_ / "models/burn-test.json", R"({
  "id": "burn-test", "version": 1, "label": "Burn", "summary": "s", "applications": "a",
  "source": "a test", "doc": "d", "parameters": [], "claims": [],
  "accuracy": [
    {"id": "work", "label": "Work", "doc": "d", "values": [
      {"id": "all", "label": "All", "doc": "d", "exact": true},
      {"id": "half", "label": "Half", "doc": "d"},
      {"id": "quarter", "label": "Quarter", "doc": "d"}]},
    {"id": "slip", "label": "Slip", "doc": "d", "values": [
      {"id": "none", "label": "None", "doc": "d", "exact": true},
      {"id": "small", "label": "Small", "doc": "d"}]}
  ]
})");
        tests::writeFile(folder_ / "models/burn-test.glsl", R"(// SPDX-License-" "Identifier: MIT-0
#include "lib/directions.glsl"

vec3 burnTest(Directions d, BurnTest p) {
    int count = 14400;
    float value = 0.5;
    if (p.work == BURN_TEST_WORK_HALF) {
        count = 7200;
        value = 0.505;
    }
    if (p.work == BURN_TEST_WORK_QUARTER) {
        count = 3600;
        value = 0.55;
    }
    if (p.slip == BURN_TEST_SLIP_SMALL) {
        value *= 1.001;
    }
    float sum = 0.0;
    for (int i = 0; i < count; ++i) {
        sum += sin(d.nl + float(i) * sum);
    }
    return vec3(value + 1e-12 * sum);
}
)");
        const std::array roots{BlockRoot{PATINA_SOURCE_DIR "/shaders", true},
                               BlockRoot{folder_.path(), false}};
        catalog = std::make_shared<const Catalog>(loadCatalog(roots));
        ASSERT_TRUE(catalog->errors.empty()) << text(catalog->errors);
        scene_ = simpleScene("burn-test");
        scene_.camera.distance = 2.5;
    }

    /// So much work to a pixel that what a model takes beside it, a hundredth, does not count.
    CostChart measured(bool combinations) {
        CostSweep::Options options;
        options.size = {24, 24};
        options.pairs.max = 25;
        options.combinations = combinations;
        return measured(options);
    }

    CostChart measured(const CostSweep::Options& options) {
        auto sweep = CostSweep::create({scene_, 0, scene_.camera, meshSource(), catalog}, options);
        EXPECT_TRUE(sweep);
        while (!(*sweep)->finished()) {
            (*sweep)->step(std::chrono::milliseconds(20));
        }
        EXPECT_EQ((*sweep)->problems(), Errors());
        return (*sweep)->chart();
    }

    tests::TemporaryFolder folder_;
    Scene scene_;
};

/// What depends on how long frames take is tested while no other test runs. A plate's two triangles
/// are shaded once per pixel; of a ball's thousands each shades whole groups of pixels.
class CostTimesTest : public CostSweepTest {
  protected:
    void SetUp() override {
        CostSweepTest::SetUp();
        scene_.objects[0].mesh = "builtin:plane";
        scene_.objects[0].rotation = {90.0, 0.0, 0.0}; // faces the camera
    }

    static void TearDownTestSuite() { known_.reset(); }

    static std::optional<CostChart> known_; ///< is that of the known block, once it was measured
};

std::optional<CostChart> CostTimesTest::known_;

/// The block's work is known, its times are the machine's: whoever else is busy on it may spoil one
/// measurement. What is wrong with the instrument would spoil all of them.
TEST_F(CostTimesTest, KnownBlock_HasItsRatiosAndErrors) {
    constexpr int attempts = 4;
    const std::map<ChosenLevels, double> known{
        {{{"work", "half"}}, 0.5}, {{{"work", "quarter"}}, 0.25}, {{{"slip", "small"}}, 1.0}};
    CostChart chart;
    std::string off = "not measured";
    for (int attempt = 0; attempt < attempts && !off.empty(); ++attempt) {
        chart = measured(false);
        off.clear();
        for (const auto& [levels, ratio] : known) {
            const double median = chart.find(levels)->cost.ratio.median;
            if (!(std::abs(median - ratio) <= 0.05 * ratio)) {
                off += fmt::format("{} takes {} for {}\n", levelsText(levels), median, ratio);
            }
        }
    }
    EXPECT_EQ(off, "");
    known_ = chart;
    EXPECT_NEAR(chart.find({{"work", "half"}})->error.p99, 0.01, 1e-6);
    EXPECT_NEAR(chart.find({{"work", "quarter"}})->error.max, 0.1, 1e-6);
    EXPECT_NEAR(chart.find({{"slip", "small"}})->error.mean, 0.001, 1e-6);
    EXPECT_EQ(chart.find({})->error.max, 0.0);
    EXPECT_EQ(chart.find({})->cost.ratio.median, 1.0);
}

TEST_F(CostTimesTest, Combinations_AreMeasuredWhereTheyMayGain) {
    const CostChart chart = measured(true);
    EXPECT_EQ(chart.points.size(), 4u); // a slip alone saves no time
}

TEST_F(CostTimesTest, Twice_GivesTheSameFront) {
    const auto frontLevels = [](const CostChart& chart) {
        std::vector<ChosenLevels> levels;
        for (const std::size_t i : costFront(chart.points)) {
            levels.push_back(chart.points[i].levels);
        }
        return levels;
    };
    const CostChart first = known_ ? *known_ : measured(false);
    EXPECT_EQ(frontLevels(first), frontLevels(measured(false)));
}

TEST_F(CostSweepTest, WhatIsDone_IsToldFromTheStart) {
    CostSweep::Options options;
    options.size = {16, 16};
    options.pairs.max = 3;
    options.combinations = false;
    auto sweep = CostSweep::create({scene_, 0, scene_.camera, meshSource(), catalog}, options);
    ASSERT_TRUE(sweep);
    std::set<std::size_t> numbers;
    double before = 0.0;
    while (!(*sweep)->finished()) {
        const SweepStep step = (*sweep)->doing();
        EXPECT_EQ(step.of, 6u); // the ground truth, the empty one, the exact one, three levels
        EXPECT_GE(step.progress(), before);
        numbers.insert(step.number);
        before = step.progress();
        (*sweep)->step(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(numbers.size(), 6u);
    EXPECT_EQ((*sweep)->progress(), 1.0);
}

TEST_F(CostSweepTest, SlowLevels_EndAfterTheirShareOfTheTime) {
    CostSweep::Options options;
    options.size = {16, 16};
    options.only = {"slip"};
    options.seconds = 1e-3;
    const CostChart chart = measured(options);
    ASSERT_EQ(chart.points.size(), 2u);
    EXPECT_EQ(chart.points.back().cost.runs, 1);
    EXPECT_FALSE(chart.points.back().cost.settled);
}

/// Without any time the singles have their one pair; that tells by far that both save most of it.
TEST_F(CostTimesTest, OutOfTime_LeavesCombinationsOutAndCountsThem) {
    tests::writeFile(folder_ / "models/burn-twice-test.json", R"({
  "id": "burn-twice-test", "version": 1, "label": "Burn twice", "summary": "s",
  "applications": "a", "source": "a test", "doc": "d", "parameters": [], "claims": [],
  "accuracy": [
    {"id": "first", "label": "First", "doc": "d", "values": [
      {"id": "all", "label": "All", "doc": "d", "exact": true},
      {"id": "none", "label": "None", "doc": "d"}]},
    {"id": "second", "label": "Second", "doc": "d", "values": [
      {"id": "all", "label": "All", "doc": "d", "exact": true},
      {"id": "none", "label": "None", "doc": "d"}]}
  ]
})");
    tests::writeFile(folder_ / "models/burn-twice-test.glsl",
                     R"(// SPDX-License-" "Identifier: MIT-0
#include "lib/directions.glsl"

vec3 burnTwiceTest(Directions d, BurnTwiceTest p) {
    bool first = p.first == BURN_TWICE_TEST_FIRST_ALL;
    bool second = p.second == BURN_TWICE_TEST_SECOND_ALL;
    float sum = 0.0;
    for (int i = 0; i < (first ? 1600 : 0) + (second ? 1600 : 0); ++i) {
        sum += sin(d.nl + float(i) * sum);
    }
    return vec3(0.5 + (first ? 0.0 : 0.01) + (second ? 0.0 : 0.02) + 1e-12 * sum);
}
)");
    const std::array roots{BlockRoot{PATINA_SOURCE_DIR "/shaders", true},
                           BlockRoot{folder_.path(), false}};
    catalog = std::make_shared<const Catalog>(loadCatalog(roots));
    ASSERT_TRUE(catalog->errors.empty()) << text(catalog->errors);
    scene_.objects[0] = object("burn-twice-test");
    CostSweep::Options options;
    options.size = {24, 24};
    options.seconds = 1e-3;
    const CostChart chart = measured(options);
    EXPECT_EQ(chart.points.size(), 3u);
    EXPECT_EQ(chart.leftOut, 1u);
    EXPECT_EQ(leftOutText(chart), "1 combination of choices was left out for want of time");
    options.seconds = 60.0;
    options.pairs.max = 7;
    const CostChart whole = measured(options);
    EXPECT_EQ(whole.points.size(), 4u);
    EXPECT_EQ(whole.leftOut, 0u);
}

TEST_F(CostSweepTest, LevelsThatChangeNothing_AreFolded) {
    scene_ = simpleScene("lambert");
    scene_.objects[0].material.parts["fresnel"] = block("fresnel", "dielectric");
    scene_.objects[0].material.parts["fresnel"].parameters["polarisation"] = std::string("s");
    CostSweep::Options options;
    options.size = {16, 16};
    options.pairs.max = 7;
    options.present = {{"fresnel.reflectance.clear", "schlick"}};
    const CostChart chart = measured(options);
    EXPECT_EQ(chart.points.size(), 1u);
    EXPECT_EQ(chart.same.size(), 2u);
    EXPECT_EQ(chart.find(options.present), &chart.points.front());
    EXPECT_NE(sameText(chart).find("drawn as Exact"), std::string::npos);
}

TEST_F(CostTimesTest, OtherMaterial_TakesNoneOfTheTime) {
    Object beside = scene_.objects[0];
    beside.material.accuracy["work"] = "quarter";
    beside.translation = glm::dvec3(1.2, 0.0, 0.0);
    scene_.objects.push_back(beside);
    scene_.objects[0].translation = glm::dvec3(-1.2, 0.0, 0.0);
    scene_.camera.distance = 4.5;
    // With the other object's time in both frames it would be (0.25 + 0.25) / (1 + 0.25).
    CostSweep::Options options;
    options.size = {32, 32};
    options.pairs.max = 15;
    options.combinations = false;
    const CostChart chart = measured(options);
    EXPECT_NEAR(chart.find({{"work", "quarter"}})->cost.ratio.median, 0.25, 0.08);
}

TEST_F(CostSweepTest, LinesOfAnOutline_AreNoError) {
    scene_.objects[0].material.parts["outline"] = block("outline", "ink-line");
    CostSweep::Options options;
    options.size = {32, 32};
    options.only = {"nothing"};
    options.pairs.min = 1;
    options.pairs.max = 1;
    EXPECT_EQ(measured(options).find({})->error.max, 0.0);
}

TEST_F(CostSweepTest, NothingInView_IsAnError) {
    scene_.objects[0].visible = false;
    auto sweep = CostSweep::create({scene_, 0, scene_.camera, meshSource(), catalog}, {});
    ASSERT_TRUE(sweep);
    (*sweep)->step(std::chrono::milliseconds(1));
    EXPECT_TRUE((*sweep)->finished());
    EXPECT_EQ((*sweep)->problems().size(), 1u);
}

/// What errors are measured against, in words.
std::string groundTruthOf(const CostSweep::Subject& subject, Choice::Scope scope) {
    CostSweep::Options options;
    options.size = {4, 4}; // with thousands of directions for each
    options.scope = scope;
    auto sweep = CostSweep::create(subject, options);
    while (sweep && (*sweep)->groundTruth() == nullptr && !(*sweep)->finished()) {
        (*sweep)->step(std::chrono::milliseconds(1));
    }
    return sweep ? (*sweep)->chart().groundTruth : sweep.error().text();
}

TEST_F(CostSweepTest, UnderAnEnvironment_TheGroundTruthFrameSaysItsDirections) {
    Scene scene = simpleScene("lambert");
    scene.setPart(kinds::environment, defaultBlockValues(*catalog->find("environment", "studio")));
    const CostSweep::Subject subject{scene, 0, scene.camera, meshSource(), catalog};
    EXPECT_EQ(groundTruthOf(subject, Choice::Scope::Material),
              "the same frame in double precision and with the same 48 directions of the "
              "environment per pixel");
    EXPECT_EQ(groundTruthOf(subject, Choice::Scope::Picture),
              "the finest frame that the device draws, with the same 4096 directions of the "
              "environment per pixel");
}

/// The device's directions are those of the frame in double precision, whatever the model's lobe.
TEST_F(CostSweepTest, UnderAnEnvironment_TheExactFrameErrsByRoundingOnly) {
    scene_ = simpleScene("cook-torrance");
    scene_.setPart(kinds::environment, defaultBlockValues(*catalog->find("environment", "studio")));
    CostSweep::Options options;
    options.size = {16, 16};
    options.only = {"nothing"};
    options.pairs.min = 1;
    options.pairs.max = 1;
    const CostChart chart = measured(options);
    EXPECT_GT(chart.find({})->error.max, 0.0);
    EXPECT_LE(chart.find({})->error.p99, 1e-4);
}

/// llvmpipe has one count of samples besides 1, other devices have more.
TEST_F(CostSweepTest, LevelsThatTheDeviceDrawsAlike_ShareAPoint) {
    Scene scene = simpleScene("lambert");
    CostSweep::Options options;
    options.size = {64, 64};
    options.scope = Choice::Scope::Picture;
    options.only = {"picture.samples"};
    options.pairs.min = 2;
    options.pairs.max = 2;
    options.combinations = false;
    options.present = {{"picture.samples", "4"}};
    auto sweep = CostSweep::create({scene, 0, scene.camera, meshSource(), catalog}, options);
    ASSERT_TRUE(sweep);
    while (!(*sweep)->finished()) {
        (*sweep)->step(std::chrono::milliseconds(20));
    }
    const CostChart chart = (*sweep)->chart();
    EXPECT_EQ(chart.points.size() + chart.same.size(), 4u);
    for (const SameLevel& each : chart.same) {
        EXPECT_NE(chart.find({{each.choice, each.level}}), nullptr);
        EXPECT_GT(each.samples, 1);
        EXPECT_NE(sameText(chart).find("drawn with " + std::to_string(each.samples)),
                  std::string::npos);
    }
    EXPECT_NE(chart.find(options.present), nullptr);
    EXPECT_NE(chart.find({{"picture.samples", "1"}}), nullptr);
}

TEST_F(CostSweepTest, ErrorMap_ShowsWhereItIsWrong) {
    scene_.camera.distance = 5.0;
    CostSweep::Options options;
    options.size = {32, 32};
    auto sweep = CostSweep::create({scene_, 0, scene_.camera, meshSource(), catalog}, options);
    ASSERT_TRUE(sweep);
    while ((*sweep)->groundTruth() == nullptr) {
        (*sweep)->step(std::chrono::milliseconds(1));
    }
    const std::vector<double> map = (*sweep)->errorMap({{"work", "half"}});
    EXPECT_EQ(map.front(), 0.0);
    EXPECT_NEAR(map[16 * 32 + 16], 0.01, 1e-6);
}

} // namespace
} // namespace patina::cost_sweep_test
