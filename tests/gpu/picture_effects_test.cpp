// SPDX-License-Identifier: GPL-3.0-or-later
// What the picture's accuracy changes in a program's text, and what it leaves alone.
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"

#include <algorithm>
#include <utility>

#include "scene/picture_choice_text.h"
#include "shading/effects/effect_key.h"
#include "shading/effects/highlight_width.h"
#include "shading_scene.h"

namespace patina::picture_effects_test {
namespace {

class PictureEffects : public ShadingTest {
  protected:
    PictureEffects() {
        scene_.objects.emplace_back();
        scene_.objects[0].material = material("phong");
        scene_.lights = {light("point")};
        scene_.setPart(kinds::fog, block("fog", "exponential"));
        scene_.part(kinds::fog)->parameters["density"] = 0.1;
    }

    static Scene with(Scene scene, std::string_view choice, std::string_view level) {
        const PictureChoiceText& text = *pictureChoiceText(choice);
        scene.accuracy.choose(text.choice, *text.level(level));
        return scene;
    }

    static EffectSet setOf(const Scene& scene) {
        return effectSet(scene.objects[0].material, scene, catalog());
    }

    static ProgramSource program(const Scene& scene,
                                 SurfaceOutput output = SurfaceOutput::Picture) {
        const auto made = surfaceProgram(setOf(scene), catalog(), output);
        EXPECT_TRUE(made) << (made ? "" : text(made.error()));
        return made ? *made : ProgramSource();
    }

    static bool has(const ShaderSource& source, std::string_view word) {
        return source.text.find(word) != std::string::npos;
    }

    /// The light stays per pixel: the text is that of the exact scene, and a sentence says why.
    static void expectPerPixel(const Scene& scene, std::string_view why) {
        const Scene chosen = with(scene, "lighting", "vertex");
        EXPECT_EQ(program(chosen).hash(), program(scene).hash());
        const std::vector<EffectLine> left = leftOutOf(chosen.objects[0].material, chosen);
        EXPECT_TRUE(std::ranges::any_of(left, [why](const EffectLine& each) {
            return each.reason.find(why) != std::string::npos;
        })) << why;
    }

    Scene scene_;
};

TEST_F(PictureEffects, Exact_WorksOutNothingAtVertices) {
    const ProgramSource exact = program(scene_);
    EXPECT_FALSE(has(exact.vertex, "SceneBlock"));
    EXPECT_TRUE(has(exact.fragment, "phong("));
    EXPECT_TRUE(has(exact.fragment, "exponentialFog("));
}

TEST_F(PictureEffects, LightAtVertices_IsOnlyThereInTheText) {
    const ProgramSource made = program(with(scene_, "lighting", "vertex"));
    EXPECT_TRUE(has(made.vertex, "phong("));
    EXPECT_FALSE(has(made.fragment, "phong("));
    EXPECT_FALSE(has(made.fragment, "pointLight("));
}

TEST_F(PictureEffects, FogAtVertices_LeavesItsColourToThePixel) {
    const ProgramSource made = program(with(scene_, "fog", "vertex"));
    EXPECT_TRUE(has(made.vertex, "exponentialFog("));
    EXPECT_FALSE(has(made.fragment, "exponentialFog("));
    EXPECT_TRUE(has(made.fragment, "exponentialFogColor("));
}

TEST_F(PictureEffects, NormalsAsBlended_AreNotMadeUnitAtThePixel) {
    const ProgramSource made = program(with(scene_, "normals", "interpolated"));
    EXPECT_FALSE(has(made.fragment, "shadingNormal("));
    EXPECT_TRUE(has(made.vertex, "safeNormalize(worldNormal"));
    EXPECT_FALSE(has(program(scene_).vertex, "safeNormalize(worldNormal"));
}

TEST_F(PictureEffects, WideHighlights_AreThoseOfTheModelAndItsSlots) {
    const ProgramSource made = program(with(scene_, "highlights", "widened"));
    EXPECT_TRUE(has(made.fragment, "model.shininess = widenedExponent(model.shininess, spread);"));
    EXPECT_FALSE(has(program(scene_).fragment, "highlightSpread"));
    scene_.objects[0].material = material("lambert");
    scene_.objects[0].material.parts["specular"] = block("specular", "gaussian");
    EXPECT_TRUE(has(program(with(scene_, "highlights", "widened")).fragment,
                    "model.specular.width = widenedAngle(model.specular.width, spread);"));
}

/// Whatever the parameter is called: its descriptor says what it is.
TEST(HighlightWidth, OfAUsersBlock_IsWidenedByItsWord) {
    Block block;
    for (const auto& [id, width] :
         {std::pair{"gloss.sharpness", HighlightWidth::Exponent},
          std::pair{"facets", HighlightWidth::Slope}, std::pair{"spreading", HighlightWidth::Angle},
          std::pair{"shininess", HighlightWidth::None}}) {
        Parameter& parameter = block.parameters.emplace_back();
        parameter.id = id;
        parameter.highlight = width;
    }
    EXPECT_TRUE(hasHighlightWidth(block));
    EXPECT_EQ(widenedSource(block, "model"),
              "    model.glossSharpness = widenedExponent(model.glossSharpness, spread);\n"
              "    model.facets = widenedSlope(model.facets, spread);\n"
              "    model.spreading = widenedAngle(model.spreading, spread);\n");
}

TEST_F(PictureEffects, WideHighlights_AreNoneOnAMattSurface) {
    for (const char* matte : {"lambert", "oren-nayar"}) {
        scene_.objects[0].material = material(matte);
        EXPECT_EQ(program(with(scene_, "highlights", "widened")).hash(), program(scene_).hash());
    }
}

TEST_F(PictureEffects, SamplesScaleAndNumbers_ChangeNoText) {
    const Scene other =
        with(with(with(scene_, "scale", "half"), "numbers", "full"), "samples", "1");
    EXPECT_EQ(program(other).hash(), program(scene_).hash());
    EffectKey keys;
    const std::uint64_t before = keys.ofScene(scene_, catalog());
    EXPECT_EQ(keys.ofScene(other, catalog()), before);
}

TEST_F(PictureEffects, FogAtVertices_IsNothingWithoutFog) {
    scene_.setPart(kinds::fog, std::nullopt);
    EXPECT_EQ(setOf(with(scene_, "fog", "vertex")), setOf(scene_));
}

TEST_F(PictureEffects, ImagesOfAMaterial_KeepItsLightPerPixel) {
    scene_.objects[0].material.textures["normal"] = textureUse("normal", "/bumps.png");
    expectPerPixel(scene_, "images");
}

TEST_F(PictureEffects, Shadows_KeepTheLightPerPixel) {
    scene_.lights[0].setPart(kinds::shadows, block("shadows", "hard"));
    expectPerPixel(scene_, "shadows");
}

TEST_F(PictureEffects, Environment_KeepsTheLightPerPixel) {
    scene_.setPart(kinds::environment, block("environment", "studio"));
    expectPerPixel(scene_, "environment");
}

TEST_F(PictureEffects, Marks_KeepTheLightPerPixel) {
    scene_.objects[0].material = material("hatching");
    expectPerPixel(scene_, "marks");
}

TEST_F(PictureEffects, BendingMaterial_HasUnitNormals) {
    scene_.objects[0].material.opacity = 0.5;
    scene_.objects[0].material.parts["refraction"] = block("refraction", "solid-body");
    const Scene chosen = with(scene_, "normals", "interpolated");
    EXPECT_EQ(program(chosen).hash(), program(scene_).hash());
}

TEST_F(PictureEffects, Inspection_IsExact) {
    Scene cheap = with(with(scene_, "fog", "vertex"), "normals", "interpolated");
    cheap = with(with(cheap, "lighting", "vertex"), "highlights", "widened");
    for (const SurfaceOutput output : {SurfaceOutput::Inspection, SurfaceOutput::Buffer}) {
        EXPECT_EQ(program(cheap, output).hash(), program(scene_, output).hash());
    }
}

TEST_F(PictureEffects, Ground_IsExact) {
    scene_.ground.mode = GroundMode::Plane;
    const auto textOf = [](const Scene& scene) {
        return surfaceProgram(groundEffects(scene, catalog()), catalog())->hash();
    };
    EXPECT_EQ(textOf(with(scene_, "fog", "vertex")), textOf(scene_));
}

TEST_F(PictureEffects, Rows_SayWhatIsDonePerVertex) {
    const auto lines =
        effectLines(setOf(with(with(scene_, "lighting", "vertex"), "fog", "vertex")));
    const auto details = [&lines](std::string_view effect) {
        const auto found = std::ranges::find(lines, effect, &EffectLine::effect);
        return found == lines.end() ? std::string() : found->detail;
    };
    EXPECT_NE(details("models/phong").find("lit per vertex"), std::string::npos);
    EXPECT_NE(details("fog/exponential").find("per vertex"), std::string::npos);
}

TEST_F(PictureEffects, Key_DiffersExactlyWhereTheSetDoes) {
    std::vector<Scene> scenes{scene_, scene_};
    scenes.back().setPart(kinds::fog, std::nullopt);
    for (const Scene& scene : {scene_, scenes[1]}) {
        for (const PictureChoiceText& text : pictureChoiceTexts()) {
            scenes.push_back(with(scene, text.id, text.levels.front().id));
            scenes.push_back(with(scene, text.id, text.levels.back().id));
        }
    }
    EffectKey keys;
    for (const Scene& a : scenes) {
        for (const Scene& b : scenes) {
            EXPECT_EQ(keys.ofScene(a, catalog()) == keys.ofScene(b, catalog()),
                      sceneEffects(a, catalog()) == sceneEffects(b, catalog()));
        }
    }
}

} // namespace
} // namespace patina::picture_effects_test
