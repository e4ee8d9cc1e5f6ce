// SPDX-License-Identifier: GPL-3.0-or-later
// Objects that are drawn with one call.
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include <glm/trigonometric.hpp>

#include "gpu_fixture.h"
#include "render/gpu/draw_slices.h"
#include "shading/effects/material_hash.h"

namespace patina::draw_batches_test {
namespace {

class DrawBatches : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    /// `side`^3 small boxes in front of the camera, turned this way and that, of twelve materials.
    Scene swarm(int side, const std::string& mesh = "cube") {
        constexpr std::array models{"lambert", "phong", "cook-torrance", "oren-nayar"};
        Scene scene = simpleScene();
        scene.objects.clear();
        for (int i = 0; i < side * side * side; ++i) {
            Object each = object(models[std::size_t(i) % models.size()], mesh);
            const double shade = 0.2 + 0.3 * double(i / 4 % 3);
            each.material.model.parameters["diffuse.color"] = glm::dvec3(shade, 0.5, 1.0 - shade);
            const glm::ivec3 cell(i % side, i / side % side, i / side / side);
            each.translation = (glm::dvec3(cell) + 0.5) * (2.0 / side) - 1.0;
            each.rotation = glm::dvec3(7.0, 11.0, 13.0) * double(i);
            each.scale = glm::dvec3(0.5 / side);
            scene.objects.push_back(each);
        }
        return scene;
    }

    /// The same picture, of objects that cannot share a call.
    static Scene oneByOne(Scene scene) {
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            scene.objects[i].material.model.parameters["no such parameter"] = double(i);
        }
        return scene;
    }

    const FrameReport& report() const { return renderer->report(); }
};

TEST_F(DrawBatches, ManyObjectsOfTwelveMaterials_TakeTwelveCalls) {
    const Scene scene = swarm(22);
    ASSERT_GT(scene.objects.size(), 10000u);
    capture(scene);
    EXPECT_EQ(report().drawnObjects, int(scene.objects.size()));
    EXPECT_EQ(report().drawCalls, 12);
    EXPECT_EQ(report().programs, 4);
}

TEST_F(DrawBatches, ManyObjects_LookAsIfDrawnOneByOne) {
    const Scene scene = swarm(22);
    const Image together = capture(scene, false, 200);
    const Image apart = capture(oneByOne(scene), false, 200);
    EXPECT_EQ(report().drawCalls, int(scene.objects.size()));
    EXPECT_EQ(together.pixels, apart.pixels);
}

TEST_F(DrawBatches, LightsThatReachSomeObjects_LookAsIfDrawnOneByOne) {
    Scene scene = swarm(6, "sphere");
    scene.lights.push_back(light("point"));
    scene.lights.back().block.parameters["position"] = glm::dvec3(-1.0, 0.5, 1.5);
    scene.lights.back().block.parameters["range"] = 1.6;
    const Image together = capture(scene, false, 100);
    EXPECT_GT(report().drawCalls, 12);
    EXPECT_LE(report().drawCalls, 24);
    const Image apart = capture(oneByOne(scene), false, 100);
    EXPECT_EQ(together.pixels, apart.pixels);
}

TEST_F(DrawBatches, OtherMesh_TakesAnotherCall) {
    Scene scene = swarm(2);
    for (Object& each : scene.objects) {
        each.material = scene.objects.front().material;
    }
    capture(scene);
    EXPECT_EQ(report().drawCalls, 1);
    scene.objects[5].mesh = "builtin:sphere";
    capture(scene);
    EXPECT_EQ(report().drawCalls, 2);
}

TEST_F(DrawBatches, TransparentObjects_TakeOneCallForEachOfTheirPasses) {
    Scene scene = swarm(2);
    for (Object& each : scene.objects) {
        each.material = scene.objects.front().material;
        each.material.opacity = 0.5;
    }
    capture(scene);
    EXPECT_EQ(report().drawCalls, 2 * int(scene.objects.size()));
}

TEST_F(DrawBatches, ObjectBesideThePicture_IsNotDrawn) {
    Scene scene = swarm(2);
    scene.objects[3].translation = {40.0, 0.0, 0.0};
    scene.objects[4].translation = {0.0, 0.0, 40.0}; // behind the eye
    capture(scene);
    EXPECT_EQ(report().drawnObjects, int(scene.objects.size()) - 2);
}

TEST_F(DrawBatches, ObjectThatComesIntoThePicture_CompilesNothing) {
    Scene scene = swarm(2);
    scene.objects[3].material.model = block("models", "ward");
    scene.objects[3].translation = {40.0, 0.0, 0.0};
    capture(scene);
    scene.objects[3].translation = {0.0, 0.0, 0.0};
    capture(scene);
    EXPECT_EQ(report().compiled, 0);
}

TEST_F(DrawBatches, ObjectAtTheEdgeOfThePicture_IsDrawn) {
    Scene scene = simpleScene();
    const double edge = std::tan(glm::radians(17.5)) * 4.0;
    scene.objects[0].scale = glm::dvec3(0.5);
    for (const glm::dvec3 side : {glm::dvec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}}) {
        scene.objects[0].translation = (edge + 0.2) * side;
        const Image image = capture(scene);
        const int x = side.x > 0.0 ? 32 : side.x < 0.0 ? 0 : 16;
        const int y = side.y > 0.0 ? 0 : side.y < 0.0 ? 32 : 16;
        EXPECT_NE(pixel(image, x, y), pixel(image, 32 - x, 32 - y));
    }
}

TEST(MaterialHash, Name_DoesNotCount) {
    Material a;
    a.name = "Gold";
    EXPECT_EQ(materialHash(a), materialHash(Material()));
}

TEST(MaterialHash, WhateverIsDrawn_Counts) {
    Material plain;
    plain.model = {"phong", 1, {{"shininess", 10.0}}, {}};
    const std::array<std::function<void(Material&)>, 9> changes{
        [](Material& m) { m.model.id = "ward"; },
        [](Material& m) { m.model.parameters["shininess"] = 11.0; },
        [](Material& m) { m.model.parameters["other"] = 10.0; },
        [](Material& m) { m.opacity = 0.5; },
        [](Material& m) { m.accuracy["fresnel"] = "exact"; },
        [](Material& m) { m.parts["fresnel"].id = "schlick"; },
        [](Material& m) { m.parts["specular"].id = "schlick"; },
        [](Material& m) { m.textures["normal"].file = "/a.png"; },
        [](Material& m) { m.textures["height"].file = "/a.png"; },
    };
    std::vector<std::uint64_t> hashes{materialHash(plain)};
    for (const auto& change : changes) {
        Material changed = plain;
        change(changed);
        hashes.push_back(materialHash(changed));
    }
    std::ranges::sort(hashes);
    EXPECT_EQ(std::ranges::adjacent_find(hashes), hashes.end());
}

/// All slices of `count` objects of `triangles` each.
std::vector<std::array<std::size_t, 4>> slices(int triangles, std::size_t count,
                                               std::int64_t maxTriangles) {
    std::vector<std::array<std::size_t, 4>> all;
    DrawSlices next;
    while (!next.isDone(count)) {
        const DrawRange range = next.next(triangles, 7, count, maxTriangles);
        all.push_back({std::size_t(range.firstTriangle), std::size_t(range.triangles),
                       range.firstInstance, range.instances});
    }
    return all;
}

TEST(DrawSlices, SmallObjects_AreTakenTogether) {
    const std::vector<std::array<std::size_t, 4>> expected{
        {0, 12, 7, 3}, {0, 12, 10, 3}, {0, 12, 13, 1}};
    EXPECT_EQ(slices(12, 7, 40), expected);
}

TEST(DrawSlices, LargeObjects_AreCut) {
    const std::vector<std::array<std::size_t, 4>> expected{
        {0, 40, 7, 1}, {40, 20, 7, 1}, {0, 40, 8, 1}, {40, 20, 8, 1}};
    EXPECT_EQ(slices(60, 2, 40), expected);
}

} // namespace
} // namespace patina::draw_batches_test
