// SPDX-License-Identifier: GPL-3.0-or-later
// An environment together with what else frames are made of: steps, shadows, the ground, images.
#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <set>
#include <vector>

#include <epoxy/gl.h>

#include "assets/texture_maker.h"
#include "environment_fixture.h"
#include "frame_target.h"
#include "render/gpu/binding.h"
#include "render/pass/pipeline_store.h"
#include "shading/effects/effect_key.h"
#include "shading/effects/textures.h"

namespace patina::environment_frames_test {
namespace {

constexpr std::chrono::milliseconds noPatience{0};

class EnvironmentFrames : public EnvironmentTest {
  protected:
    void SetUp() override {
        EnvironmentTest::SetUp();
        size_ = 64;
        target_.emplace(size_);
    }

    void TearDown() override {
        target_.reset();
        EnvironmentTest::TearDown();
    }

    bool begin(const Scene& scene, const View& view) {
        return drawInWindow(scene, view, squares(), target_->name());
    }

    void finish(bool isDone) {
        while (!isDone && !proceed(noPatience)) {
        }
        if (!isDone) {
            renderer->job().show(target_->name());
        }
    }

    /// The next frame of these programs is drawn in tiles.
    void makeSlow(const Scene& scene, const View& view) {
        finish(begin(scene, view));
        renderer->job().noteTime(5000.0);
    }

    /// What the mean of the frames so far is.
    Image mean(const Scene& scene, View view) {
        view.isContinued = true;
        auto image = renderer->capture(scene, view, squares(), false);
        EXPECT_TRUE(image);
        return image ? *image : Image();
    }

    /// Returns a scene with a shadow and a ground.
    Scene everything() {
        Scene scene = inTheStudio("cook-torrance");
        scene.lights = {sun({0.5, -1.0, -0.5})};
        scene.lights[0].setPart(kinds::shadows, block("shadows", "filtered"));
        scene.ground.mode = GroundMode::Plane;
        return scene;
    }

    std::optional<FrameTarget> target_;
};

TEST_F(EnvironmentFrames, InTiles_AreThePictureDrawnAtOnce) {
    const Scene scene = inTheStudio("cook-torrance");
    const View view = viewWith(scene, 4);
    const Image atOnce = settled(scene, 4);
    makeSlow(scene, view);
    ASSERT_FALSE(begin(scene, view));
    finish(false);
    EXPECT_EQ(mean(scene, view).pixels, atOnce.pixels);
}

TEST_F(EnvironmentFrames, Tile_IsNoSample) {
    const Scene scene = inTheStudio("cook-torrance");
    View view = viewWith(scene, 4);
    makeSlow(scene, view);
    view.isContinued = true;
    ASSERT_FALSE(begin(scene, view));
    int before = 0; // tiles after which nothing was added yet
    while (!proceed(noPatience)) {
        before += renderer->job().environmentSamples() == 4;
    }
    EXPECT_GT(before, 0);
    EXPECT_EQ(renderer->job().environmentSamples(), 8);
}

TEST_F(EnvironmentFrames, GivenUp_AddNothing) {
    const Scene scene = inTheStudio("cook-torrance");
    View view = viewWith(scene, 4);
    makeSlow(scene, view);
    const Image before = mean(scene, view);
    view.isContinued = true;
    ASSERT_FALSE(begin(scene, view));
    proceed(noPatience);
    EXPECT_EQ(mean(scene, view).pixels, before.pixels);
    EXPECT_EQ(renderer->job().environmentSamples(), 4);
}

TEST_F(EnvironmentFrames, AfterANewOneThatWasGivenUp_BeginAgain) {
    const Scene scene = inTheStudio("cook-torrance");
    View view = viewWith(scene, 4);
    const Image expected = settled(scene, 4);
    Scene other = scene;
    other.part(kinds::environment)->parameters["rotate"] = 90.0;
    makeSlow(other, view);
    ASSERT_FALSE(begin(scene, view));
    proceed(noPatience);
    view.isContinued = true;
    finish(begin(scene, view));
    EXPECT_EQ(mean(scene, view).pixels, expected.pixels);
}

TEST_F(EnvironmentFrames, Prewarming_LeavesTheMeanAsItIs) {
    const Scene scene = inTheStudio("cook-torrance");
    const Image before = settled(scene, 8);
    Scene without = scene;
    without.part(kinds::environment)->parameters["intensity"] = 0.0;
    View ahead = viewWith(scene, 4);
    ahead.effects = &without;
    ASSERT_TRUE(prewarm(scene, ahead, squares()));
    EXPECT_EQ(renderer->job().environmentSamples(), 8);
    EXPECT_EQ(mean(scene, viewWith(scene, 4)).pixels, before.pixels);
}

TEST_F(EnvironmentFrames, WithAGround_AreInTilesAndTheSamePicture) {
    const Scene scene = everything();
    const View view = viewWith(scene, 4);
    const Image atOnce = settled(scene, 4);
    makeSlow(scene, view);
    ASSERT_FALSE(begin(scene, view));
    finish(false);
    EXPECT_EQ(mean(scene, view).pixels, atOnce.pixels);
}

TEST_F(EnvironmentFrames, GroundUnderAWhiteSky_ShowsItsOwnColour) {
    Scene scene = surrounded("lambert", plain(1.0f));
    scene.ground.mode = GroundMode::Plane;
    scene.ground.color = {0.5, 0.25, 0.125};
    scene.camera.pitch = 60.0;
    scene.camera.distance = 8.0;
    const Image image = settled(scene, 4);
    const glm::vec3 corner = pixel(image, 1, size_ - 2);
    EXPECT_NEAR(corner.r, 0.5f, 2e-3f);
    EXPECT_NEAR(corner.g, 0.25f, 2e-3f);
    EXPECT_NEAR(corner.b, 0.125f, 2e-3f);
}

/// The sun adds as much as the sky: where it is kept away, half of the light is left.
TEST_F(EnvironmentFrames, ShadowOnAGround_KeepsTheEnvironmentsLight) {
    Scene scene = surrounded("lambert", plain(1.0f));
    scene.objects[0].mesh = "builtin:sphere";
    scene.lights = {sun({0.0, -1.0, 0.0})};
    scene.lights[0].setPart(kinds::shadows, block("shadows", "hard"));
    scene.ground.mode = GroundMode::Shadows;
    scene.camera.pitch = 20.0;
    scene.camera.distance = 8.0;
    scene.background = glm::dvec3(0.5);
    float darkest = 1.0f;
    Scene bare = scene;
    bare.objects[0].material.model.parameters["diffuse.color"] = glm::dvec3(1.0);
    const Image image = settled(bare, 4);
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        darkest = std::min(darkest, image.pixels[i]);
    }
    EXPECT_NEAR(darkest, 0.25f, 5e-3f);
}

TEST_F(EnvironmentFrames, ImageOnTheColour_IsLitAsItIs) {
    Scene scene = surrounded("lambert", plain(1.0f));
    makeWhite(scene);
    scene.objects[0].material.textures["diffuse.color"] = textureUse("diffuse.color", "red.png");
    renderer->setTextures([](const TextureUse&, TextureDecoding decoding) {
        const FileImage red{{1, 1, 3, {0.5f, 0.25f, 0.125f}}, 0};
        return TextureLookup{std::make_shared<const TexturePicture>(madeTexture(red, decoding)),
                             false};
    });
    const glm::vec3 seen = middle(settled(scene, 1024));
    EXPECT_NEAR(seen.g / seen.r, 0.5f, 5e-3f);
    EXPECT_NEAR(seen.r, 0.5f, 5e-3f);
}

TEST_F(EnvironmentFrames, NormalMap_TurnsWhatIsSeenOfTheSky) {
    Image sky = plain(0.0f, {64, 32});
    std::fill_n(sky.pixels.begin(), sky.pixels.size() / 2, 1.0f); // above the horizon
    Scene scene = surrounded("lambert", sky);
    makeWhite(scene);
    const float upright = middle(settled(scene, 1024)).g;
    scene.objects[0].material.textures["normal"] = textureUse("normal", "up.png");
    renderer->setTextures([](const TextureUse&, TextureDecoding decoding) {
        const FileImage bent{{1, 1, 3, {0.5f, 0.5f + 0.5f * 0.6f, 0.5f + 0.5f * 0.8f}}, 32};
        return TextureLookup{std::make_shared<const TexturePicture>(madeTexture(bent, decoding)),
                             false};
    });
    // The share of an even sky that a surface sees: (1 + n.up) / 2.
    EXPECT_NEAR(upright, 0.5f, 0.01f);
    EXPECT_NEAR(middle(settled(scene, 1024)).g, 0.8f, 0.01f);
}

/// The units of all samplers of a linked program.
std::vector<int> samplerUnits(const gl::Program& program) {
    std::vector<int> units;
    GLint count = 0;
    glGetProgramiv(program.name(), GL_ACTIVE_UNIFORMS, &count);
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        std::array<GLchar, 256> name{};
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program.name(), i, GLsizei(name.size()), nullptr, &size, &type,
                           name.data());
        const std::set<GLenum> samplers{GL_SAMPLER_2D, GL_SAMPLER_2D_ARRAY,
                                        GL_SAMPLER_2D_ARRAY_SHADOW, GL_SAMPLER_2D_SHADOW};
        if (samplers.contains(type)) {
            GLint unit = -1;
            glGetUniformiv(program.name(), program.uniform(name.data()), &unit);
            units.push_back(unit);
        }
    }
    return units;
}

TEST_F(EnvironmentFrames, ProgramWithEverySampler_HasAUnitForEach) {
    Scene scene = surrounded("cook-torrance", plain(1.0f));
    scene.lights = {sun({0.5, -1.0, -0.5})};
    scene.lights[0].setPart(kinds::shadows, block("shadows", "soft"));
    Material& material = scene.objects[0].material;
    for (const Parameter& parameter : catalog->find("models", "cook-torrance")->parameters) {
        if (!parameter.textureChannels.empty() && material.textures.size() < maxTextures - 2) {
            material.textures[parameter.id] = textureUse(parameter.id, "image.png");
        }
    }
    for (const char* key : {"normal", "opacity"}) {
        material.textures[key] = textureUse(key, "image.png");
    }
    PipelineStore store({}, SurfaceOutput::Picture);
    store.setCatalog(catalog);
    const auto& entry = store.get(material, EffectKey::ofMaterial(material, *catalog),
                                  {scene, EffectKey().ofScene(scene, *catalog)});
    ASSERT_TRUE(entry.pipeline);
    const std::vector<int> units = samplerUnits(*entry.pipeline->program);
    EXPECT_EQ(units.size(), material.textures.size() + 3); // shadows, the table and the picture
    EXPECT_EQ(std::set<int>(units.begin(), units.end()).size(), units.size());
    for (const int unit : units) {
        EXPECT_GT(unit, 0);  // where textures are made and passes read
        EXPECT_LT(unit, 16); // what every driver has
    }
}

/// Whatever a material has, the units of its images end where those of every driver do.
TEST(TextureUnits, OfAllKinds_AreDistinctAndFewEnough) {
    std::set<unsigned> units{binding::environmentTable, binding::environmentImage,
                             binding::environmentSmall, binding::shadowMaps};
    for (unsigned i = 0; i < maxTextures; ++i) {
        units.insert(binding::firstTexture + i);
    }
    EXPECT_EQ(units.size(), 4 + maxTextures);
    EXPECT_LE(*units.rbegin(), 15U);
}

} // namespace
} // namespace patina::environment_frames_test
