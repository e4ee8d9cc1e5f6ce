// SPDX-License-Identifier: GPL-3.0-or-later
// What descriptors say of how far their blocks work, against the blocks' own code.
#include <gtest/gtest.h>

#include "physics_cases.h"
#include "shading/effects/fog.h"

namespace patina::physics::bounds_test {
namespace {

TEST(FogBounds, EveryFog_HidesWhatItsDescriptorSays) {
    for (const Block* block : catalog().ofKind("fog")) {
        ASSERT_TRUE(block->hides) << block->id;
        const Subject fog("fog", block->id);
        for (double x = 0.0; x < 60.0; x += 0.37) {
            const double said = *hiddenShare(*block, defaultValues(*block), x);
            const double hidden = 1.0 - fog.code->fog({{}, {0.0, 0.0, -1.0}, x}, fog.parameters);
            EXPECT_LE(hidden, said + 1e-12) << block->id << " at " << x;
            EXPECT_GE(hidden, block->hides->atMost ? 0.0 : said - 1e-12) << block->id << x;
        }
    }
}

/// Its mean density on the way, by the descriptor's base and thickness, is the block's own.
TEST(FogBounds, FogThatFallsWithHeight_HidesAsItsDescriptorSays) {
    int layers = 0;
    for (const Block* block : catalog().ofKind("fog")) {
        const Values values{{"density", 0.7}};
        const auto layer = fogLayer(*block, values);
        if (!layer) {
            continue;
        }
        ++layers;
        const Subject fog("fog", block->id, values);
        for (const double eye : {-4.0, -0.5, 0.0, 1.0}) {
            for (const double rise : {-0.9, -0.1, 0.0, 0.4, 1.0}) {
                const glm::dvec3 way(0.0, rise, -std::sqrt(1.0 - rise * rise));
                const double hidden =
                    1.0 - fog.code->fog({{0.0, eye, 0.0}, way, 3.0}, fog.parameters);
                EXPECT_NEAR(hidden,
                            *hiddenShare(*block, values, 3.0,
                                         layer->between(eye, eye + 3.0 * rise)),
                            1e-12)
                    << block->id << ' ' << eye << ' ' << rise;
            }
        }
    }
    EXPECT_GT(layers, 0);
}

TEST(LightBounds, BeyondTheRange_NothingArrives) {
    for (const Block* block : catalog().ofKind("lights")) {
        if (!block->reach || block->reach->range.empty()) {
            continue;
        }
        Values values{{block->reach->range, 2.0}, {block->reach->from, glm::dvec3(0, 2, 0)}};
        if (!block->reach->axis.empty()) {
            values[block->reach->axis] = glm::dvec3(0, -1, 0);
        }
        const Subject light("lights", block->id, values);
        EXPECT_EQ(light.code->light({0, 0, 0}, light.parameters).radiance, glm::dvec3(0.0));
        EXPECT_GT(light.code->light({0, 0.01, 0}, light.parameters).radiance.g, 0.0);
    }
}

TEST(LightBounds, RangeOfZero_ChangesNothing) {
    const Subject usual("lights", "point");
    const Subject endless("lights", "point", {{"range", 0.0}});
    const Subject far("lights", "point", {{"range", 1e6}});
    const glm::dvec3 x(0.3, -1.0, 4.0);
    const double radiance = usual.code->light(x, usual.parameters).radiance.r;
    EXPECT_EQ(endless.code->light(x, endless.parameters).radiance.r, radiance);
    EXPECT_NEAR(far.code->light(x, far.parameters).radiance.r, radiance, 1e-12);
}

/// KHR_lights_punctual: 1 - (x / range)^4.
TEST(LightBounds, HalfWayToTheEnd_FifteenSixteenthsAreLeft) {
    const Subject light("lights", "point", {{"range", 4.0}, {"position", glm::dvec3(0, 2, 0)}});
    EXPECT_DOUBLE_EQ(light.code->light({0, 0, 0}, light.parameters).radiance.g, 15.0 / 16.0);
}

} // namespace
} // namespace patina::physics::bounds_test
