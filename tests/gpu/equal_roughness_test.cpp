// SPDX-License-Identifier: GPL-3.0-or-later
// Models that have no grain where two roughnesses are the same.
#include "gpu_fixture.h"

namespace patina::equal_roughness_test {
namespace {

/// Where the roughnesses meet the program changes, and the picture must not.
class EqualRoughness : public GpuTest, public testing::WithParamInterface<const char*> {};

TEST_P(EqualRoughness, Picture_IsThatOfNearlyEqualOnes) {
    makeRenderer();
    Scene scene = simpleScene(GetParam());
    Values& values = scene.objects[0].material.model.parameters;
    const bool isWard = values.contains("roughness.x");
    const std::string stem = isWard ? "roughness." : "shininess.";
    const double value = isWard ? 0.25 : 50.0;
    values[stem + "x"] = value;
    values[stem + "y"] = value;
    const Image equal = capture(scene);
    values[stem + "y"] = value * (1.0 + 1e-6);
    const Image nearly = capture(scene);
    EXPECT_EQ(renderer->report().compiled, 1);
    for (std::size_t i = 0; i < equal.pixels.size(); ++i) {
        ASSERT_NEAR(equal.pixels[i], nearly.pixels[i], 2e-3 * (1.0 + nearly.pixels[i])) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Models, EqualRoughness, testing::Values("ward", "ashikhmin-shirley"));

} // namespace
} // namespace patina::equal_roughness_test
