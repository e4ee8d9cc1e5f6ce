// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <epoxy/gl.h>

#include "gpu_fixture.h"

namespace patina::renderer_test {
namespace {

/// A half float keeps 11 bits.
constexpr float half = 1e-3f;

class RendererTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    static bool isLight(const Image& image) {
        return std::all_of(image.pixels.begin(), image.pixels.end(), [](float channel) {
            return std::isfinite(channel) && channel >= 0.0f && channel <= 65504.0f;
        });
    }

    const FrameReport& report() const { return renderer->report(); }
};

TEST_F(RendererTest, WhitePlateFacingTheLight_ShowsOne) {
    EXPECT_NEAR(middle(capture(plate())).g, 1.0f, half);
}

TEST_F(RendererTest, LightAtSixtyDegrees_ShowsHalf) {
    Scene scene = plate();
    scene.lights[0].block.parameters["direction"] = glm::dvec3(0.0, -std::sqrt(0.75), -0.5);
    EXPECT_NEAR(middle(capture(scene)).g, 0.5f, half);
}

TEST_F(RendererTest, TwoLights_AddUp) {
    Scene scene = plate();
    scene.lights.push_back(scene.lights[0]);
    EXPECT_NEAR(middle(capture(scene)).g, 2.0f, 2.0f * half);
}

TEST_F(RendererTest, PointLight_FallsOffWithTheSquare) {
    Scene scene = plate();
    scene.lights = {light("point")};
    Values& values = scene.lights[0].block.parameters;
    values["position"] = glm::dvec3(0.0, 0.0, 2.0);
    values["falloff"] = std::string("inverse-square");
    EXPECT_NEAR(middle(capture(scene)).g, 0.25f, half);
}

TEST_F(RendererTest, HeadLight_MovesWithTheCamera) {
    Scene scene = simpleScene("lambert");
    scene.lights = {light("head")};
    scene.lights[0].block.parameters["offset"] = glm::dvec3(0.0);
    const float before = middle(capture(scene)).g;
    scene.camera.yaw = 140.0;
    EXPECT_NEAR(middle(capture(scene)).g, before, 2e-3f);
}

TEST_F(RendererTest, Ambient_IsTheDiffuseShare) {
    Scene scene = plate();
    scene.lights.clear();
    scene.ambient = {0.1, 0.2, 0.3};
    EXPECT_NEAR(middle(capture(scene)).b, 0.3f, half);
}

TEST_F(RendererTest, LinearFogHalfWay_MixesHalf) {
    Scene scene = plate();
    scene.setPart(kinds::fog, block("fog", "linear"));
    scene.part(kinds::fog)->parameters["color"] = glm::dvec3(0.0);
    scene.part(kinds::fog)->parameters["start"] = scene.camera.distance - 1.0;
    scene.part(kinds::fog)->parameters["end"] = scene.camera.distance + 1.0;
    EXPECT_NEAR(middle(capture(scene)).g, 0.5f, 2e-3f);
}

TEST_F(RendererTest, FresnelWithoutSlot_BlendsByItsReflectance) {
    Scene scene = plate();
    scene.objects[0].material.parts["fresnel"] = block("fresnel", "schlick");
    Values& values = scene.objects[0].material.parts["fresnel"].parameters;
    values["f0"] = glm::dvec3(0.5);
    values["color"] = glm::dvec3(0.0);
    EXPECT_NEAR(middle(capture(scene)).g, 0.5f, 2e-3f);
}

TEST_F(RendererTest, BackSide_IsLitLikeAFront) {
    Scene scene = plate();
    scene.objects[0].rotation.x += 180.0;
    EXPECT_NEAR(middle(capture(scene)).g, 1.0f, half);
}

TEST_F(RendererTest, MirroringScale_KeepsTheLight) {
    Scene scene = plate();
    scene.objects[0].scale = {-1.0, 1.0, 1.0};
    EXPECT_NEAR(middle(capture(scene)).g, 1.0f, half);
}

TEST_F(RendererTest, NonUniformScale_KeepsNormalsPerpendicular) {
    // A sphere squashed to a disc faces the viewer nearly everywhere.
    Scene scene = simpleScene("lambert");
    scene.objects[0].material.model.parameters["diffuse.color"] = glm::dvec3(1.0);
    scene.objects[0].scale = {1.0, 1.0, 0.01};
    EXPECT_GT(pixel(capture(scene), 12, 16).g, 0.99f);
}

TEST_F(RendererTest, Background_IsLinear) {
    EXPECT_EQ(pixel(capture(simpleScene()), 0, 0), glm::vec3(0.25f));
}

TEST_F(RendererTest, DisplayOfTheBackground_IsSrgb) {
    EXPECT_NEAR(pixel(capture(simpleScene(), true), 0, 0).g, 0.5371f, 0.5f / 255.0f);
}

TEST_F(RendererTest, OneStop_DoublesTheLight) {
    Scene scene = simpleScene();
    scene.exposure = 1.0;
    EXPECT_EQ(pixel(capture(scene), 0, 0), glm::vec3(0.5f));
}

TEST_F(RendererTest, NeutralToneMapping_KeepsABaseColour) {
    // 0.04 is what a dielectric reflects; the mapping takes it away again.
    Scene scene = simpleScene();
    scene.background = glm::dvec3(0.44);
    scene.setPart(kinds::tone, block("tone", "khronos-neutral"));
    EXPECT_NEAR(pixel(capture(scene, true), 0, 0).g, 0.6652f, 0.6f / 255.0f);
}

TEST_F(RendererTest, NeutralToneMapping_FollowsThePublishedFormula) {
    // Linear colours, and what Khronos' PBR Neutral specification makes of them, sRGB encoded.
    const std::pair<glm::dvec3, glm::vec3> known[] = {
        {{4.0, 2.0, 0.5}, {0.9926f, 0.8210f, 0.6519f}}, // compressed and bleached
        {{1.0, 1.0, 1.0}, {0.9401f, 0.9401f, 0.9401f}},
        {{0.0, 10.0, 0.0}, {0.7804f, 0.9973f, 0.7804f}},
        {{0.05, 0.02, 0.3}, {0.1981f, 0.0323f, 0.5680f}}}; // a channel below 0.08
    Scene scene = simpleScene();
    scene.setPart(kinds::tone, block("tone", "khronos-neutral"));
    for (const auto& [light, shown] : known) {
        scene.background = light;
        const glm::vec3 found = pixel(capture(scene, true), 0, 0);
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(found[i], shown[i], 0.7f / 255.0f) << light[0] << ", channel " << i;
        }
    }
}

TEST_F(RendererTest, FourSamples_SmoothTheEdges) {
    Scene scene = plate();
    scene.background = glm::dvec3(0.0);
    scene.objects[0].scale = glm::dvec3(0.5);
    scene.camera.yaw = 50.0;
    const auto inBetween = [&](int samples) {
        View view = viewOf(scene);
        view.samples = samples;
        const Image image = *renderer->capture(scene, view, meshSource(), false);
        const float lit = middle(image).g;
        int count = 0;
        for (int i = 0; i < image.width * image.height; ++i) {
            const float value = pixel(image, i % image.width, i / image.width).g;
            count += value > 0.1f * lit && value < 0.9f * lit ? 1 : 0;
        }
        return count;
    };
    EXPECT_EQ(inBetween(1), 0);
    EXPECT_GT(inBetween(4), 4);
}

TEST_F(RendererTest, VeryBrightLight_EndsAtTheTargetsRange) {
    Scene scene = plate();
    for (int i = 0; i < 10; ++i) {
        scene.lights.push_back(scene.lights[0]);
        scene.lights.back().block.parameters["intensity"] = 10000.0;
    }
    EXPECT_EQ(middle(capture(scene)).g, 65504.0f);
}

TEST_F(RendererTest, EveryModelOnEveryMesh_IsFiniteAndNotBlack) {
    for (const Block* model : catalog->ofKind("models")) {
        for (const std::string& name : primitiveNames()) {
            Scene scene = simpleScene(model->id);
            scene.objects[0].mesh = "builtin:" + name;
            // A mirror alone is black wherever it mirrors no light.
            scene.objects[0].material.model.parameters["diffuse.color"] = glm::dvec3(0.5);
            scene.camera.pitch = 20.0;
            scene.lights = {sun({0.0, -0.5, -1.0})};
            const Image image = capture(scene);
            EXPECT_TRUE(isLight(image)) << model->id << " on " << name;
            const bool isDark = model->id == "grating"; // it has no matte part
            EXPECT_TRUE(isDark || middle(image).r > 0.0f) << model->id << " on " << name;
        }
    }
}

TEST_F(RendererTest, ParametersAtTheirLimits_AreFinite) {
    for (const Block* model : catalog->ofKind("models")) {
        for (const bool upper : {false, true}) {
            Scene scene = simpleScene(model->id);
            for (const Parameter& parameter : model->parameters) {
                if (parameter.type == ParameterType::Float) {
                    scene.objects[0].material.model.parameters[parameter.id] =
                        upper ? parameter.max : parameter.min;
                }
            }
            EXPECT_TRUE(isLight(capture(scene))) << model->id << (upper ? " max" : " min");
        }
    }
}

TEST_F(RendererTest, NotANumberInAValue_DoesNotReachTheImage) {
    Scene scene = simpleScene("phong");
    scene.objects[0].material.model.parameters["shininess"] =
        std::numeric_limits<double>::quiet_NaN();
    scene.ambient = glm::dvec3(std::numeric_limits<double>::infinity());
    EXPECT_TRUE(isLight(capture(scene)));
}

TEST_F(RendererTest, Outline_HasNoBlackPixels) {
    // Against a bright background a dark rim shows as pixels below both neighbours.
    Scene scene = simpleScene("lambert");
    scene.objects[0].material.model.parameters["diffuse.color"] = glm::dvec3(1.0);
    scene.ambient = glm::dvec3(0.5);
    const Image image = capture(scene, false, 65);
    for (int x = 0; x < image.width; ++x) {
        EXPECT_GT(pixel(image, x, 32).g, 0.2f) << x;
    }
}

TEST_F(RendererTest, MissingMesh_IsSkipped) {
    Scene scene = simpleScene();
    scene.objects.push_back(object("phong", "not-there-yet"));
    capture(scene);
    EXPECT_EQ(report().drawnObjects, 1);
}

TEST_F(RendererTest, UnknownModel_IsDrawnAsAFallback) {
    Scene scene = simpleScene();
    scene.objects[0].material.model.id = "from-the-future";
    EXPECT_NE(middle(capture(scene)), glm::vec3(0.25f));
}

TEST_F(RendererTest, UnknownModelWithAFresnelTerm_IsDrawnAsTheSameFallback) {
    Scene scene = simpleScene();
    scene.objects[0].material.model.id = "from-the-future";
    const Image plain = capture(scene);
    scene.objects[0].material.parts["fresnel"] = {"schlick", 1, {{"f0", 0.9}}};
    EXPECT_EQ(capture(scene).pixels, plain.pixels);
}

TEST_F(RendererTest, Opacity_MixesWithWhatIsBehind) {
    Scene scene = plate();
    scene.objects[0].material.opacity = 0.25;
    EXPECT_NEAR(middle(capture(scene)).g, 0.25f * 1.0f + 0.75f * 0.25f, 2e-3f);
}

/// Red in front of green, both half there: the order in the scene must not matter.
TEST_F(RendererTest, TransparentObjects_AreBlendedBackToFront) {
    Scene scene = plate();
    scene.background = glm::dvec3(0.0);
    scene.objects.push_back(scene.objects[0]);
    Object& front = scene.objects[0];
    Object& back = scene.objects[1];
    front.translation = {0.0, 0.0, 0.5};
    front.material.opacity = back.material.opacity = 0.5;
    front.material.model.parameters["diffuse.color"] = glm::dvec3(1.0, 0.0, 0.0);
    back.material.model.parameters["diffuse.color"] = glm::dvec3(0.0, 1.0, 0.0);
    const Image image = capture(scene);
    EXPECT_NEAR(middle(image).r, 0.5f, half);
    EXPECT_NEAR(middle(image).g, 0.25f, half);
    std::swap(scene.objects[0], scene.objects[1]);
    EXPECT_EQ(capture(scene), image);
}

TEST_F(RendererTest, OpaqueObjectBehind_ShowsThrough) {
    Scene scene = plate();
    scene.objects.push_back(scene.objects[0]);
    scene.objects[0].translation = {0.0, 0.0, 0.5};
    scene.objects[0].material.opacity = 0.5;
    scene.objects[0].material.model.parameters["diffuse.color"] = glm::dvec3(0.0);
    EXPECT_NEAR(middle(capture(scene)).g, 0.5f, half);
}

TEST_F(RendererTest, NothingChanged_UploadsNothing) {
    const Scene scene = simpleScene("phong");
    capture(scene);
    capture(scene);
    EXPECT_EQ(report().uploadedBuffers, 0);
}

TEST_F(RendererTest, ChangedParameter_UploadsTheMaterialOnly) {
    Scene scene = simpleScene("phong");
    scene.objects.push_back(object("lambert", "torus"));
    capture(scene);
    scene.objects[0].material.model.parameters["shininess"] = 12.0;
    capture(scene);
    EXPECT_EQ(report().uploadedBuffers, 1);
}

TEST_F(RendererTest, MovedCamera_UploadsTheViewOnly) {
    Scene scene = simpleScene("phong");
    capture(scene);
    scene.camera.yaw += 5.0;
    capture(scene);
    EXPECT_EQ(report().uploadedBuffers, 1);
}

TEST_F(RendererTest, ChangedParameter_CompilesNothing) {
    Scene scene = simpleScene("phong");
    capture(scene);
    scene.objects[0].material.model.parameters["shininess"] = 99.0;
    capture(scene);
    EXPECT_EQ(report().compiled, 0);
}

TEST_F(RendererTest, SwappedModelAndBack_CompilesOnce) {
    Scene scene = simpleScene("phong");
    capture(scene);
    Scene other = simpleScene("strauss");
    capture(other);
    EXPECT_EQ(report().compiled, 1);
    capture(scene);
    EXPECT_EQ(report().compiled, 0);
}

TEST_F(RendererTest, ThreeHundredSpots_AllShine) {
    Scene scene = plate();
    Light spot = light("spot");
    spot.block.parameters["position"] = glm::dvec3(0.0, 0.0, 2.0);
    spot.block.parameters["direction"] = glm::dvec3(0.0, 0.0, -1.0);
    spot.block.parameters["intensity"] = 0.01;
    scene.lights = {spot};
    const float one = middle(capture(scene)).g;
    ASSERT_GT(one, 0.0f);
    scene.lights.assign(300, spot);
    EXPECT_NEAR(middle(capture(scene)).g / one, 300.0f, 1.0f);
    EXPECT_EQ(text(report().messages), "");
}

TEST_F(RendererTest, MoreLightsThanFit_AreReported) {
    Scene scene = plate();
    scene.lights.assign(5000, scene.lights[0]);
    capture(scene);
    ASSERT_EQ(report().messages.size(), 1u);
    EXPECT_NE(report().messages[0].text().find("lights are left out"), std::string::npos);
}

TEST_F(RendererTest, ImageTooLarge_SaysWhatIsPossible) {
    const Scene scene = simpleScene();
    View view = viewOf(scene);
    view.size = {200000, 2};
    const auto image = renderer->capture(scene, view, meshSource(), true);
    ASSERT_FALSE(image);
    EXPECT_NE(image.error().text().find("pixels a side"), std::string::npos);
}

TEST_F(RendererTest, AfterAnImageTooLarge_DrawsAgain) {
    const Scene scene = plate();
    View view = viewOf(scene);
    view.size = {200000, 2};
    EXPECT_FALSE(renderer->capture(scene, view, meshSource(), true));
    EXPECT_NEAR(middle(capture(scene)).g, 1.0f, half);
}

TEST_F(RendererTest, NewMeshAtAnOldAddress_IsSeen) {
    Mesh shown = *primitive("plane");
    const MeshSource source = [&shown](const Object&) { return shown.view(); };
    Scene scene = plate();
    ASSERT_TRUE(renderer->capture(scene, viewOf(scene), source, false));
    for (Vertex& vertex : shown.vertices) {
        vertex.position *= 0.01f;
    }
    const auto image = renderer->capture(scene, viewOf(scene), source, false);
    EXPECT_EQ(pixel(*image, 10, 16), glm::vec3(0.25f));
}

} // namespace
} // namespace patina::renderer_test
