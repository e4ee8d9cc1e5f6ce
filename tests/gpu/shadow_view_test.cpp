// SPDX-License-Identifier: GPL-3.0-or-later
// What shaders get to know of a parallel light's map leads to the same place in it as the matrix
// with which the map is drawn.
#include "render/lights/shadow_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "shading/effects/data_layout.h"
#include "shading_scene.h"

namespace patina::shadow_view_test {
namespace {

class ShadowViewTest : public ShadingTest {
  protected:
    using Data = std::array<glm::vec4, ShadowLayout::vec4s>;

    static ShadowView viewOf(std::span<const CasterBox> casters) {
        const Light sun = light("directional");
        return shadowViewOf(*catalog().find("lights", "directional"), sun.block.parameters,
                            glm::dmat4(1.0), casters, 1024);
    }

    static Data packedView(const ShadowView& view) {
        Data data;
        packView(data, view);
        return data;
    }

    /// Computes what passes/shadows_parallel.glsl does.
    static glm::dvec3 seen(const Data& data, const glm::dvec3& x) {
        const glm::dvec3 from = x - glm::dvec3(data[3]);
        return {glm::dot(from, glm::dvec3(data[0])), glm::dot(from, glm::dvec3(data[1])),
                glm::dot(from, glm::dvec3(data[2]))};
    }
};

TEST_F(ShadowViewTest, PlaceInTheMap_IsThatOfTheMatrix) {
    for (const double far : {0.0, 50.0}) {
        const glm::vec3 middle(far, -far, 2.0 * far);
        const std::vector<CasterBox> casters{
            {{middle - glm::vec3(1.0f), middle + glm::vec3(1.0f)}, glm::dmat4(1.0)}};
        const ShadowView view = viewOf(casters);
        const double doubt = 1e-6 * (1.0 + std::max(std::abs(view.near), std::abs(view.far)) /
                                               (view.far - view.near));
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec4 x = cornerOf(casters[0].bounds, corner);
            const glm::dvec3 drawn = 0.5 * glm::dvec3(shadowClip(view, 0) * x) + 0.5;
            const glm::dvec3 found = seen(packedView(view), glm::dvec3(x));
            EXPECT_NEAR(found.x, drawn.x, 2e-5);
            EXPECT_NEAR(found.y, drawn.y, 2e-5);
            EXPECT_NEAR(found.z, drawn.z - doubt, 2e-5);
        }
    }
}

TEST_F(ShadowViewTest, Depths_AreBehindNothingByWhatFloatsRound) {
    const std::vector<CasterBox> casters{
        {{glm::vec3(-1.0f), glm::vec3(1.0f)}, glm::dmat4(1.0)}};
    const ShadowView view = viewOf(casters);
    const glm::dvec3 nearest = view.near * view.forward;
    const double off = seen(packedView(view), nearest).z;
    EXPECT_LT(off, -1e-6);
    EXPECT_GT(off, -4e-6);
}

TEST_F(ShadowViewTest, WithoutCasters_EveryPlaceIsOutside) {
    const Data data = packedView(viewOf({}));
    for (const glm::dvec3& x : {glm::dvec3(0.0), glm::dvec3(0.5), glm::dvec3(-3.0, 7.0, 1e6)}) {
        const glm::dvec3 place = seen(data, x);
        EXPECT_FALSE(place.x > 0.0 && place.x < 1.0 && place.y > 0.0 && place.y < 1.0);
    }
}

} // namespace
} // namespace patina::shadow_view_test
