// SPDX-License-Identifier: GPL-3.0-or-later
// What objects hide of the light from all around from themselves.
#include <cmath>

#include "core/mesh_openness.h"
#include "environment_fixture.h"
#include "render/surfaces/inspection_drawer.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/occlusion.h"
#include "shading/effects/surface_program.h"

namespace patina::occlusion_test {
namespace {

/// A quad; its normal is that of its corners' order.
void addQuad(Mesh& mesh, const glm::vec3& origin, const glm::vec3& u, const glm::vec3& v) {
    constexpr int side = 8;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int y = 0; y <= side; ++y) {
        for (int x = 0; x <= side; ++x) {
            Vertex vertex;
            vertex.position = origin + u * (float(x) / side) + v * (float(y) / side);
            vertex.normal = glm::normalize(glm::cross(u, v));
            vertex.tangent = glm::vec4(glm::normalize(u), 1.0f);
            mesh.vertices.push_back(vertex);
        }
    }
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t at = first + y * (side + 1) + x;
            mesh.indices.insert(mesh.indices.end(),
                                {at, at + 1, at + side + 2, at, at + side + 2, at + side + 1});
        }
    }
}

/// A plate that faces the camera, with a groove down its middle, as wide as it is deep.
Mesh grooved() {
    Mesh mesh;
    const glm::vec3 down(0.0f, 2.0f, 0.0f);
    addQuad(mesh, {-1.0f, -1.0f, 0.0f}, {0.75f, 0.0f, 0.0f}, down);
    addQuad(mesh, {0.25f, -1.0f, 0.0f}, {0.75f, 0.0f, 0.0f}, down);
    addQuad(mesh, {-0.25f, -1.0f, -0.5f}, {0.5f, 0.0f, 0.0f}, down);
    addQuad(mesh, {-0.25f, -1.0f, 0.0f}, {0.0f, 0.0f, -0.5f}, down);
    addQuad(mesh, {0.25f, -1.0f, -0.5f}, {0.0f, 0.0f, 0.5f}, down);
    mesh.bounds = boundsOf(mesh.vertices);
    return mesh;
}

class OcclusionTest : public EnvironmentTest {
  protected:
    void SetUp() override {
        EnvironmentTest::SetUp();
        meshes["grooved"] = grooved();
        openness["grooved"] = opennessOf(meshes["grooved"].view());
    }

    /// Under a white sky.
    Scene plate(const std::string& model = "lambert") {
        Scene scene = surrounded(model, plain(1.0f));
        scene.objects[0].mesh = "builtin:grooved";
        makeWhite(scene);
        return scene;
    }

    static Scene occluded(Scene scene) {
        scene.occlusion = true;
        return scene;
    }

    static Scene fitted(Scene scene) {
        scene.accuracy.choose(PictureChoice::Environment, 1);
        return scene;
    }

    Scene ambient() {
        Scene scene = plate();
        scene.setPart(kinds::environment, std::nullopt);
        scene.ambient = glm::dvec3(1.0);
        return scene;
    }

    /// Returns what the middle of the groove's floor sees of its surroundings.
    float share() {
        const Mesh& mesh = meshes["grooved"];
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            if (glm::distance(mesh.vertices[i].position, glm::vec3(0.0f, 0.0f, -0.5f)) < 1e-5f) {
                return unpacked(openness["grooved"][i], mesh.vertices[i].normal).share;
            }
        }
        return -1.0f;
    }

    static glm::vec3 besideTheGroove(const Image& image) {
        return pixel(image, 8, image.height / 2);
    }

    std::string textOf(const Scene& scene) const {
        const auto program =
            surfaceProgram(effectSet(scene.objects[0].material, scene, *catalog), *catalog);
        return program ? program->vertex.text + program->fragment.text : std::string();
    }
};

/// What a view shows in place of the picture; stripes where the scene does not ask for it.
TEST_F(OcclusionTest, ViewOfItAlone_IsTheShareThatAPlaceSees) {
    const auto shown = [this](const Scene& scene, bool display) {
        const auto image = renderer->inspection().capture(scene, viewOf(scene, 65), meshSource(),
                                                          display, InspectedView::Occlusion);
        return image ? *image : Image();
    };
    const Image image = shown(occluded(plate()), false);
    ASSERT_EQ(image.width, 65);
    EXPECT_NEAR(middle(image).r, share(), 0.02f);
    EXPECT_NEAR(besideTheGroove(image).r, 1.0f, 0.02f);
    EXPECT_NEAR(middle(shown(plate(), true)).r, 0.385f, 0.05f); // of either stripe
}

TEST_F(OcclusionTest, WhiteSkyWithoutTheEffect_IsWhiteInTheGrooveToo) {
    for (const Scene& scene : {plate(), fitted(plate()), ambient()}) {
        const Image image = settled(scene, 1024);
        EXPECT_NEAR(middle(image).r, 1.0f, 0.02f);
        EXPECT_NEAR(besideTheGroove(image).r, 1.0f, 0.02f);
    }
}

TEST_F(OcclusionTest, WhiteSky_IsDarkerInTheGrooveByItsOpenness) {
    ASSERT_GT(share(), 0.2f);
    ASSERT_LT(share(), 0.6f);
    EXPECT_NEAR(middle(settled(occluded(fitted(plate())), 4)).r, share(), 0.02f);
    EXPECT_NEAR(middle(settled(occluded(ambient()), 4)).r, share(), 0.01f);
    EXPECT_NEAR(middle(settled(occluded(plate()), 4096)).r, share(), 0.06f);
}

TEST_F(OcclusionTest, WhatHidesNothing_IsAsWithoutTheEffect) {
    for (const std::string model : {"lambert", "cook-torrance"}) {
        for (const Scene& scene : {plate(model), fitted(plate(model))}) {
            const Image before = settled(scene, 64);
            const Image after = settled(occluded(scene), 64);
            const glm::vec3 was = besideTheGroove(before);
            EXPECT_NEAR(besideTheGroove(after).r, was.r, 0.002f * was.r) << model;
            EXPECT_LT(middle(after).r, middle(before).r) << model;
        }
    }
}

/// Whose mesh has no openness yet.
TEST_F(OcclusionTest, MeshWithoutOpenness_IsAsWithoutTheEffect) {
    openness.clear();
    const Scene scene = fitted(plate("cook-torrance"));
    const Image before = settled(scene, 4);
    const Image after = settled(occluded(scene), 4);
    for (std::size_t i = 0; i < before.pixels.size(); ++i) {
        ASSERT_NEAR(after.pixels[i], before.pixels[i], 0.002f) << i;
    }
}

TEST_F(OcclusionTest, OpennessThatComesLater_IsShown) {
    const auto all = openness;
    openness.clear();
    const Scene scene = occluded(fitted(plate()));
    EXPECT_NEAR(middle(settled(scene, 4)).r, 1.0f, 0.02f);
    openness = all;
    EXPECT_NEAR(middle(settled(scene, 4)).r, share(), 0.02f);
}

/// Stretched, squeezed and turned: what sees everything does so at any scale.
TEST_F(OcclusionTest, Scale_DarkensNothing) {
    Scene scene = occluded(fitted(plate()));
    scene.objects[0].mesh = "builtin:sphere";
    openness["sphere"] = opennessOf(mesh(scene.objects[0]));
    scene.objects[0].scale = {1.0, 0.3, 2.0};
    scene.objects[0].rotation = {20.0, 30.0, 40.0};
    EXPECT_NEAR(middle(settled(scene, 4)).r, 1.0f, 0.02f);
}

TEST_F(OcclusionTest, EveryModel_GivesFiniteLightThatIsNotBrighter) {
    size_ = 9;
    for (const Block* model : catalog->ofKind(kinds::models)) {
        for (const Scene& scene : {fitted(plate(model->id)), plate(model->id)}) {
            const Image open = settled(scene, 8);
            const Image image = settled(occluded(scene), 8);
            for (std::size_t i = 0; i < image.pixels.size(); ++i) {
                ASSERT_TRUE(std::isfinite(image.pixels[i])) << model->id;
                ASSERT_GE(image.pixels[i], 0.0f) << model->id;
                ASSERT_LE(image.pixels[i], open.pixels[i] * 1.002f + 1e-4f) << model->id;
            }
        }
    }
}

TEST_F(OcclusionTest, WithoutLightFromAllAround_TheTextIsTheSameBytes) {
    const Scene lit = simpleScene("cook-torrance");
    EXPECT_EQ(textOf(occluded(lit)), textOf(lit));
    EXPECT_EQ(textOf(lit).find("open"), std::string::npos);
    const Scene under = plate("cook-torrance");
    EXPECT_EQ(textOf(under).find("openness"), std::string::npos);
    EXPECT_NE(textOf(occluded(under)).find("packedOpenness"), std::string::npos);
}

TEST_F(OcclusionTest, Openness_IsNeededOnlyUnderLightFromAllAround) {
    Scene scene;
    scene.ambient = glm::dvec3(0.1);
    EXPECT_FALSE(needsOpenness(scene, *catalog));
    scene.occlusion = true;
    EXPECT_TRUE(needsOpenness(scene, *catalog));
    scene.ambient = glm::dvec3(0.0);
    EXPECT_FALSE(needsOpenness(scene, *catalog));
    scene.setPart(kinds::environment, plate().parts.at(std::string(kinds::environment)));
    EXPECT_TRUE(needsOpenness(scene, *catalog));
}

TEST_F(OcclusionTest, ValueThatIsDragged_CompilesNothing) {
    Scene scene = occluded(fitted(plate("cook-torrance")));
    settled(scene, 4);
    scene.objects[0].material.model.parameters["roughness"] = 0.31;
    settled(scene, 4);
    EXPECT_EQ(renderer->report().compiled, 0);
}

} // namespace
} // namespace patina::occlusion_test
