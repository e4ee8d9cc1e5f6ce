// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image_places.h"

#include <gtest/gtest.h>

#include "scene/primitives.h"

namespace patina::image_places_test {
namespace {

TEST(ImagePlaces, VerticesAtOnePlace_HaveNone) {
    std::vector<Vertex> vertices(5);
    EXPECT_FALSE(hasImagePlaces(vertices));
    vertices.back().uv.y = 0.5f;
    EXPECT_TRUE(hasImagePlaces(vertices));
    EXPECT_FALSE(hasImagePlaces({}));
}

TEST(ImagePlaces, MeshesMadeByCode_HaveThem) {
    for (const char* name : {"sphere", "cube", "plane", "torus"}) {
        const auto mesh = primitive(name);
        ASSERT_TRUE(mesh) << name;
        EXPECT_TRUE(hasImagePlaces(mesh->vertices)) << name;
    }
}

TEST(ImagePlaces, VeryManyVertices_AreSampledHereAndThere) {
    std::vector<Vertex> vertices(std::size_t(3) << 20);
    EXPECT_FALSE(hasImagePlaces(vertices));
    for (std::size_t i = vertices.size() / 2; i < vertices.size(); ++i) {
        vertices[i].uv.x = 1.0f;
    }
    EXPECT_TRUE(hasImagePlaces(vertices));
}

} // namespace
} // namespace patina::image_places_test
