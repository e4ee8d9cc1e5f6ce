// SPDX-License-Identifier: GPL-3.0-or-later
// What effects cost, by leaving them out.
#include "measure/cost/effect_cost.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>

#include "gpu_fixture.h"
#include "measure/time/median_interval.h"
#include "support/program.h"

namespace patina::effect_cost_test {
namespace {

TEST(MedianInterval, NoSamples_AreZero) {
    EXPECT_EQ(medianInterval({}), MedianInterval());
}

TEST(MedianInterval, FewSamples_SpanAll) {
    EXPECT_EQ(medianInterval({3.0, 1.0, 2.0}), (MedianInterval{2.0, 1.0, 3.0}));
}

/// The ranks of the least and the greatest sample that the interval of so many has.
std::pair<double, double> ranksOf(int count) {
    std::vector<double> samples;
    for (int i = count; i > 0; --i) {
        samples.push_back(i);
    }
    const MedianInterval interval = medianInterval(samples);
    return {interval.lower, interval.upper};
}

/// The tables say for n = 6, 9, 15 and 20: 1 6, 2 8, 4 12, 6 15.
TEST(MedianInterval, Ranks_AreThoseOfTheTables) {
    EXPECT_EQ(ranksOf(6), std::pair(1.0, 6.0));
    EXPECT_EQ(ranksOf(9), std::pair(2.0, 8.0));
    EXPECT_EQ(ranksOf(15), std::pair(4.0, 12.0));
    EXPECT_EQ(ranksOf(20), std::pair(6.0, 15.0));
}

/// They lie 1.96 standard deviations of n fair coins, sqrt(n) / 2, from the middle. A chance
/// of 2^-n, from n = 1075 on, is 0.
TEST(MedianInterval, VeryManySamples_HaveTheRanksOfTheNormalDistribution) {
    for (const int count : {1000, 1074, 1075, 1200, 100000}) {
        const auto [lower, upper] = ranksOf(count);
        const double reach = 0.98 * std::sqrt(count);
        EXPECT_NEAR(lower, 0.5 * count - reach, 1.5) << count;
        EXPECT_EQ(upper, count + 1 - lower) << count;
    }
}

TEST(MedianInterval, EvenCount_TakesTheMiddleOfTwo) {
    EXPECT_DOUBLE_EQ(medianInterval({1.0, 2.0, 4.0, 9.0}).median, 3.0);
}

/// A fog that works hard, and an object that fills the picture.
class EffectCostTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        tests::writeFile(folder_ / "fog/heavy.json", R"({
  "id": "heavy", "version": 1, "label": "Heavy", "summary": "s", "applications": "a",
  "source": "a test", "doc": "d", "parameters": [], "claims": []
})");
        tests::writeFile(folder_ / "fog/heavy.glsl", R"(// SPDX-License-" "Identifier: MIT-0
#include "lib/fog_ray.glsl"

float heavyFog(FogRay ray, HeavyFog p) {
    float sum = 0.0;
    for (int i = 0; i < 150; ++i) {
        sum += sin(ray.range + float(i) * sum);
    }
    return 0.5 + 1e-6 * sum;
}

vec3 heavyFogColor(HeavyFog p) {
    return vec3(0.5);
}
)");
        const std::array roots{BlockRoot{PATINA_SOURCE_DIR "/shaders", true},
                               BlockRoot{folder_.path(), false}};
        catalog = std::make_shared<const Catalog>(loadCatalog(roots));
        ASSERT_TRUE(catalog->errors.empty()) << text(catalog->errors);
        scene_ = simpleScene("lambert");
        scene_.camera.distance = 2.0;
    }

    EffectCosts measured(int rounds) {
        rows_ = effectRows(scene_, 0, *catalog);
        auto meter = EffectCostMeter::create({scene_, scene_.camera, meshSource(), rows_, catalog},
                                             {{64, 64}, rounds, {}});
        EXPECT_TRUE(meter);
        while (!(*meter)->finished()) {
            (*meter)->step();
        }
        return (*meter)->costs();
    }

    tests::TemporaryFolder folder_;
    Scene scene_;
    std::vector<EffectRow> rows_;
};

TEST_F(EffectCostTest, HeavyEffect_CostsMoreThanNothing) {
    scene_.setPart(kinds::fog, block("fog", "heavy"));
    const EffectCosts costs = measured(7);
    const EffectCost* fog = costs.of("fog/heavy");
    ASSERT_NE(fog, nullptr);
    EXPECT_FALSE(fog->belowNoise());
    EXPECT_GT(fog->milliseconds.median, 0.0);
}

TEST_F(EffectCostTest, HeavyEffect_IsMostOfTheFrame) {
    scene_.setPart(kinds::fog, block("fog", "heavy"));
    const EffectCosts costs = measured(7);
    EXPECT_GT(costs.of("fog/heavy")->milliseconds.median, 0.5 * costs.frame.median);
}

TEST_F(EffectCostTest, Passes_AreTimedByWhatTheyDraw) {
    scene_.setPart(kinds::fog, block("fog", "heavy"));
    scene_.lights[0].setPart(kinds::shadows, block("shadows", "hard"));
    scene_.ground.mode = GroundMode::Plane;
    const EffectCosts costs = measured(1);
    std::map<std::string, double> times;
    for (const PassCost& cost : costs.passes) {
        EXPECT_TRUE(times.emplace(cost.pass, cost.milliseconds.median).second) << cost.pass;
    }
    EXPECT_GT(times.at("shadow maps"), 0.0);
    EXPECT_GT(times.at("solid objects"), times.at("resolve"));
    EXPECT_TRUE(times.contains("picture passes and tone curve"));
}

TEST_F(EffectCostTest, SumAndRest_AreTheFrame) {
    scene_.ambient = glm::dvec3(0.1);
    const EffectCosts costs = measured(2);
    EXPECT_NEAR(sumOf(costs, rows_) + costs.rest, costs.frame.median, 1e-9);
}

TEST_F(EffectCostTest, Sum_CountsNoEffectTwice) {
    scene_.ambient = glm::dvec3(0.1);
    const EffectCosts costs = measured(2);
    const EffectCost& model = *costs.of("models/lambert");
    EXPECT_DOUBLE_EQ(sumOf(costs, rows_), model.belowNoise() ? 0.0 : model.milliseconds.median);
}

/// The rows that show a time add up to it.
TEST(EffectCosts, Sum_HasNothingThatIsBelowNoise) {
    EffectCosts costs;
    costs.effects = {{"fog/linear", {3.0, 2.0, 4.0}}, {"ambient", {5.0, -1.0, 9.0}}};
    std::vector<EffectRow> rows(2);
    rows[0].line.effect = "fog/linear";
    rows[1].line.effect = "ambient";
    EXPECT_DOUBLE_EQ(sumOf(costs, rows), 3.0);
}

TEST_F(EffectCostTest, EveryRemovableEffect_IsMeasured) {
    scene_.ambient = glm::dvec3(0.1);
    scene_.setPart(kinds::fog, block("fog", "linear"));
    scene_.lights[0].setPart(kinds::shadows, block("shadows", "hard"));
    scene_.ground.mode = GroundMode::Plane;
    const EffectCosts costs = measured(1);
    ASSERT_NE(costs.of("shadows/hard"), nullptr);
    ASSERT_NE(costs.of("ground"), nullptr);
    for (const EffectRow& row : rows_) {
        EXPECT_EQ(costs.of(row.line.effect) != nullptr, row.in && row.removable) << row.line.effect;
    }
}

/// One pair, of the whole frame and one without the first effect, whatever the time.
TEST_F(EffectCostTest, WithoutTime_DrawsOnePair) {
    rows_ = effectRows(scene_, 0, *catalog);
    auto meter = EffectCostMeter::create({scene_, scene_.camera, meshSource(), rows_, catalog},
                                         {{16, 16}, 100, {}, 0.0});
    ASSERT_TRUE(meter);
    while (!(*meter)->finished()) {
        (*meter)->step();
    }
    const EffectCosts costs = (*meter)->costs();
    ASSERT_EQ(costs.effects.size(), 1u);
    EXPECT_EQ(costs.effects[0].pairs, 1);
    EXPECT_FALSE(costs.effects[0].isSure());
    EXPECT_EQ(costs.pairs, 0);
    EXPECT_GT(costs.secondsNeeded, 0.0);
    EXPECT_GT(costs.frame.median, 0.0);
}

TEST_F(EffectCostTest, WithTime_IsSure) {
    scene_.setPart(kinds::fog, block("fog", "linear"));
    const EffectCosts costs = measured(7);
    EXPECT_EQ(costs.pairs, 7);
    EXPECT_EQ(costs.secondsNeeded, 0.0);
    EXPECT_TRUE(std::ranges::all_of(costs.effects, &EffectCost::isSure));
}

/// So slow a fog that the fewest rounds, which once were drawn whatever the time, take far longer
/// than there is; what programs take to be made comes on top.
TEST_F(EffectCostTest, SlowFrames_EndInTime) {
    scene_.setPart(kinds::fog, block("fog", "heavy"));
    scene_.ambient = glm::dvec3(0.1);
    rows_ = effectRows(scene_, 0, *catalog);
    const auto secondsOf = [this](double seconds, bool mayShrink) {
        auto meter = EffectCostMeter::create({scene_, scene_.camera, meshSource(), rows_, catalog},
                                             {{256, 256}, 60, {}, seconds, mayShrink});
        EXPECT_TRUE(meter);
        const auto began = std::chrono::steady_clock::now();
        while (!(*meter)->finished()) {
            (*meter)->step();
        }
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - began;
        return std::pair(time.count(), (*meter)->costs());
    };
    const auto [compiling, first] = secondsOf(0.0, false);
    ASSERT_GT(first.secondsNeeded, 0.0);
    const double enough = 0.2 * first.secondsNeeded;
    const auto [time, costs] = secondsOf(enough, false);
    EXPECT_LT(time, compiling + 1.5 * enough);
    EXPECT_EQ(costs.size, glm::ivec2(256));
    EXPECT_GT(costs.secondsNeeded, enough);
    const auto [smaller, shrunk] = secondsOf(enough, true);
    EXPECT_LT(smaller, compiling + 1.5 * enough);
    EXPECT_LT(shrunk.size.x, 256);
}

TEST_F(EffectCostTest, StepByStep_ProgressGrowsToOne) {
    rows_ = effectRows(scene_, 0, *catalog);
    auto meter = EffectCostMeter::create({scene_, scene_.camera, meshSource(), rows_, catalog},
                                         {{16, 16}, 1, {}});
    ASSERT_TRUE(meter);
    double before = -1.0;
    while (!(*meter)->finished()) {
        EXPECT_GT((*meter)->progress(), before);
        before = (*meter)->progress();
        (*meter)->step();
    }
    EXPECT_EQ((*meter)->progress(), 1.0);
}

} // namespace
} // namespace patina::effect_cost_test
