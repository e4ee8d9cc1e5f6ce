// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/camera_moves.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/primitives.h"
#include "viewport/ray_cast.h"
#include "viewport/turning.h"

namespace patina::tests::camera_moves_test {
namespace {

/// Rounding of a few double operations on numbers of about one.
constexpr double tolerance = 1e-9;

/// The lowest and the highest place of a mesh in a view whose edges are at -1 and 1.
glm::dvec2 heightsInView(const Camera& camera, const Object& object, const Mesh& mesh) {
    glm::dvec2 heights(1e9, -1e9);
    const double edge = std::tan(0.5 * glm::radians(camera.fieldOfView));
    for (const Vertex& vertex : mesh.vertices) {
        const glm::dvec4 world = worldMatrix(object) * glm::dvec4(vertex.position, 1.0);
        const glm::dvec4 seen = viewMatrix(camera) * world;
        const double height = seen.y / -seen.z / edge;
        heights = {std::min(heights.x, height), std::max(heights.y, height)};
    }
    return heights;
}

TEST(CameraMoves, OrbitPastThePole_StopsThere) {
    EXPECT_EQ(orbited(Camera(), 0.0, 500.0).pitch, 90.0);
}

TEST(CameraMoves, Orbit_KeepsDistanceAndPivot) {
    const Camera moved = orbited(Camera(), 33.0, 12.0);
    EXPECT_NEAR(glm::distance(eye(moved), moved.pivot), Camera().distance, tolerance);
}

TEST(CameraMoves, DollyToNothing_KeepsAPositiveDistance) {
    EXPECT_GT(dollied(Camera(), 0.0).distance, 0.0);
}

TEST(CameraMoves, Pan_MovesThePivotPointWithThePointer) {
    const glm::dvec2 size{800.0, 600.0};
    const Camera moved = panned(Camera(), {37.0, -21.0}, size.y);
    // What was under the middle of the view is now under the place the pointer went to.
    const Ray ray = rayThrough(moved, 0.5 * size + glm::dvec2{37.0, -21.0}, size);
    const glm::dvec3 toPivot = Camera().pivot - ray.origin;
    EXPECT_NEAR(glm::length(glm::cross(ray.direction, toPivot)), 0.0, tolerance);
}

TEST(CameraMoves, Frame_FillsMostOfTheHeightInTheMiddle) {
    Object object;
    object.translation = {2.0, -1.0, 0.5};
    const Mesh ball = *primitive("shaderball");
    const Camera moved = framed(orbited(Camera(), 20.0, 30.0), object, ball.view(), 1.5);
    const glm::dvec2 heights = heightsInView(moved, object, ball);
    EXPECT_NEAR(heights.x, -0.88, tolerance);
    EXPECT_NEAR(heights.y, 0.88, tolerance);
}

TEST(CameraMoves, FrameInANarrowView_FitsTheWidth) {
    const Mesh sphere = *primitive("sphere");
    const Camera moved = framed(Camera(), Object(), sphere.view(), 0.5);
    EXPECT_NEAR(heightsInView(moved, Object(), sphere).y, 0.5 * 0.88, 0.01); // of facets
}

TEST(CameraMoves, FrameOfNothing_ChangesNothing) {
    EXPECT_EQ(framed(Camera(), Object(), MeshView(), 1.0), Camera());
}

TEST(CameraMoves, PivotElsewhere_LeavesTheEyeWhereItWas) {
    const Camera moved = pivotedAt(Camera(), {0.4, -0.2, 0.3});
    EXPECT_NEAR(glm::distance(eye(moved), eye(Camera())), 0.0, tolerance);
}

TEST(Turning, ObjectByNothing_KeepsItsPlacement) {
    Object object;
    object.rotation = {20.0, -35.0, 50.0};
    Object same = object;
    same.rotation = turnedRotation(object.rotation, Camera(), 0.0, 0.0);
    const glm::dmat4 before = worldMatrix(object);
    const glm::dmat4 after = worldMatrix(same);
    for (int column = 0; column < 3; ++column) {
        EXPECT_NEAR(glm::distance(before[column], after[column]), 0.0, tolerance);
    }
}

TEST(Turning, ObjectByYaw_TurnsItsFrontTowardsTheRight) {
    Object object;
    object.rotation = turnedRotation({0.0, 0.0, 0.0}, Camera(), 90.0, 0.0);
    const glm::dvec3 front(worldMatrix(object) * glm::dvec4(0.0, 0.0, 1.0, 0.0));
    EXPECT_NEAR(glm::distance(front, glm::dvec3(1.0, 0.0, 0.0)), 0.0, tolerance);
}

TEST(RayCast, ThroughTwoSurfaces_HitsTheNearer) {
    // Two triangles across the line of sight, one metre in front of the pivot and one behind.
    Camera camera;
    camera.yaw = 0.0;
    camera.pitch = 0.0;
    Mesh mesh;
    for (const float z : {-1.0f, 1.0f}) {
        for (const glm::vec3 corner :
             {glm::vec3(-1, -1, z), glm::vec3(1, -1, z), glm::vec3(0, 2, z)}) {
            Vertex vertex;
            vertex.position = corner;
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            mesh.vertices.push_back(vertex);
        }
    }
    mesh.bounds = boundsOf(mesh.vertices);
    Scene scene;
    scene.objects.emplace_back();
    const auto hit = cast(rayThrough(camera, {50.0, 50.0}, {100.0, 100.0}), scene,
                          [&](const Object&) { return mesh.view(); });
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->point.z, 1.0, tolerance);
}

TEST(RayCast, WithBoxesAroundRuns_HitsWhatItHitsWithout) {
    const Mesh ball = *primitive("shaderball");
    const std::vector<Bounds> runs = runBoundsOf(ball.view());
    const PickMesh boxed(ball.view(), runs);
    Scene scene;
    scene.objects.emplace_back().rotation = {10.0, 20.0, 30.0};
    for (int i = 0; i < 400; ++i) {
        const Ray ray = rayThrough(Camera(), {5.0 * (i % 20), 0.25 * i}, {100.0, 100.0});
        EXPECT_EQ(cast(ray, scene, [&](const Object&) { return boxed; }),
                  cast(ray, scene, [&](const Object&) { return ball.view(); }));
    }
}

TEST(RayCast, AlongASideOfARunsBox_HitsWhatItHitsWithout) {
    const Mesh cube = *primitive("cube");
    const std::vector<Bounds> runs = runBoundsOf(cube.view());
    const PickMesh boxed(cube.view(), runs);
    Scene scene;
    scene.objects.emplace_back();
    const glm::dvec3 corner(cube.bounds.upper);
    for (const glm::dvec3 from :
         {glm::dvec3(corner.x, 0.0, 5.0), glm::dvec3(corner.x, corner.y, 5.0),
          glm::dvec3(0.0, corner.y, 5.0)}) {
        const Ray ray{from, {0.0, 0.0, -1.0}};
        EXPECT_EQ(cast(ray, scene, [&](const Object&) { return boxed; }),
                  cast(ray, scene, [&](const Object&) { return cube.view(); }));
    }
}

TEST(RayCast, AtAHiddenObject_HitsNothing) {
    Scene scene;
    scene.objects.emplace_back().visible = false;
    const auto hit = cast(Ray(), scene, [](const Object&) -> MeshView {
        ADD_FAILURE() << "the mesh of a hidden object was asked for";
        return {};
    });
    EXPECT_FALSE(hit.has_value());
}

} // namespace
} // namespace patina::tests::camera_moves_test
