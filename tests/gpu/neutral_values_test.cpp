// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that give 0 everywhere by their values are in no program.
#include "shading/effects/neutral_values.h"

#include <algorithm>
#include <string>
#include <vector>

#include "gpu_fixture.h"
#include "render/surfaces/object_rows.h"
#include "shading/effects/effect_key.h"
#include "shading/effects/surface_program.h"

namespace patina::neutral_values_test {
namespace {

struct Neutral {
    std::string kind;
    std::string id;
    Values values;
    std::string why;
    std::string model = "phong"; ///< of the material that has the block
};

void PrintTo(const Neutral& neutral, std::ostream* out) {
    *out << neutral.kind << '/' << neutral.id << " in " << neutral.model;
}

const glm::dvec3 black(0.0);

const std::vector<Neutral> neutrals{
    {"fresnel", "constant", {{"f0", black}}, "Its “Reflectance” is black."},
    {"fresnel", "constant", {{"f0", black}}, "Its “Reflectance” is black.", "cook-torrance"},
    {"fresnel", "constant", {{"f0", black}}, "Its “Reflectance” is black.", "ashikhmin-shirley"},
    {"fresnel",
     "dielectric",
     {{"index.inside", 1.3}, {"index.outside", 1.3}},
     "Its “Index outside” and “Index inside” are both 1.3.",
     "cook-torrance"},
    {"fresnel", "blinn-f0", {{"f0", black}}, "Its “Reflectance facing you” is black."},
    {"fresnel",
     "empirical",
     {{"bias", -0.5}, {"scale", 0.0}},
     "Its “Everywhere” and “Added at the rim” are not above 0."},
    {"fresnel",
     "conductor",
     {{"eta", glm::dvec3(1.0)}, {"k", black}},
     "Its “Index outside” and “Refractive index” are both 1, and its “Absorption” is 0."},
    {"specular",
     "phong",
     {{"specular.color", black}},
     "Its “Highlight colour” is black.",
     "lambert"},
    {"specular", "gaussian", {{"gloss", 0.0}}, "Its “Gloss” is 0.", "oren-nayar"},
};

class NeutralValues : public GpuTest, public testing::WithParamInterface<Neutral> {
  protected:
    Scene scene() const {
        Scene made = simpleScene(GetParam().model);
        BlockValues& part = made.objects[0].material.parts[GetParam().kind];
        part = block(GetParam().kind, GetParam().id);
        for (const auto& [id, value] : GetParam().values) {
            part.parameters[id] = value;
        }
        made.camera.yaw = 25.0;
        return made;
    }

    std::string name() const { return GetParam().kind + '/' + GetParam().id; }

    /// The blocks as they would be if no descriptor said when they do nothing.
    std::shared_ptr<const Catalog> silent() const {
        auto made = std::make_shared<Catalog>(*catalog);
        for (Block& each : made->blocks) {
            each.neutral.clear();
        }
        return made;
    }

    bool isInTheFrame() const { return std::ranges::count(renderer->report().effects, name()) > 0; }
};

TEST_P(NeutralValues, AreInNoProgramAndInNoPixel) {
    makeRenderer();
    const Image without = capture(scene(), false, 48);
    EXPECT_FALSE(isInTheFrame());
    renderer->setCatalog(silent());
    const Image with = capture(scene(), false, 48);
    EXPECT_TRUE(isInTheFrame());
    EXPECT_EQ(with.pixels, without.pixels);
}

TEST_P(NeutralValues, HaveARowThatSaysWhy) {
    const auto rows = objectRows(scene(), 0, *catalog, meshSource());
    const auto row = std::ranges::find_if(
        rows, [this](const EffectRow& each) { return each.line.effect == name(); });
    ASSERT_NE(row, rows.end());
    EXPECT_FALSE(row->in);
    EXPECT_EQ(row->line.reason, GetParam().why);
}

TEST_P(NeutralValues, WithAnImageOnOne_StayIn) {
    Material material = scene().objects[0].material;
    const BlockValues& part = material.parts[GetParam().kind];
    const Block& neutral = *catalog->find(GetParam().kind, GetParam().id);
    EXPECT_TRUE(isNeutralPart(neutral, part.parameters, material));
    material.textures[GetParam().kind + ".color"].file = "a.png";
    EXPECT_FALSE(isNeutralPart(neutral, part.parameters, material));
}

INSTANTIATE_TEST_SUITE_P(Kinds, NeutralValues, testing::ValuesIn(neutrals));

class NeutralSceneTest : public GpuTest {};

/// Schlick's form of it brightens the rim however dark the middle is.
TEST_F(NeutralSceneTest, CheaperFormThatIsNotZero_StaysIn) {
    const Block& fresnel = *catalog->find("fresnel", "blinn-f0");
    const Values values{{"f0", black}};
    EXPECT_TRUE(isNeutral(fresnel, values));
    EXPECT_FALSE(isNeutral(fresnel, values, {{"reflectance.f0", "schlick"}}));
}

TEST_F(NeutralSceneTest, WarmTermThatHadTheIndexAround_StaysIn) {
    const Block& fresnel = *catalog->find("fresnel", "dielectric");
    Values values{{"index.inside", 1.3}, {"index.outside", 1.3}, {"temperature", 80.0}};
    EXPECT_TRUE(isNeutral(fresnel, values));
    values["temperature.slope"] = -1e-4;
    EXPECT_FALSE(isNeutral(fresnel, values));
}

/// The index that results is in the place of the one that was measured.
TEST_F(NeutralSceneTest, TemperatureOfATerm_IsInNoTextAndChangesThePicture) {
    makeRenderer();
    const auto text = [this](const Scene& scene) {
        const auto program =
            surfaceProgram(effectSet(scene.objects[0].material, scene, *catalog), *catalog);
        return program ? program->fragment.text : std::string();
    };
    Scene scene = simpleScene("cook-torrance");
    BlockValues& term = scene.objects[0].material.parts["fresnel"];
    term = block("fresnel", "dielectric");
    const std::string plain = text(scene);
    EXPECT_NE(plain.find("dielectricFresnel"), std::string::npos);
    EXPECT_EQ(plain.find("emperature"), std::string::npos);
    term.parameters["index.inside"] = 1.5;
    term.parameters["temperature"] = 120.0;
    term.parameters["temperature.slope"] = -1e-3;
    EXPECT_EQ(text(scene), plain);
    const Image warm = capture(scene);
    term = block("fresnel", "dielectric");
    EXPECT_NE(warm, capture(scene));
    term.parameters["index.inside"] = 1.4;
    EXPECT_EQ(warm, capture(scene));
}

TEST_F(NeutralSceneTest, DarkStudio_IsInNoProgramAndInNoPixel) {
    makeRenderer();
    Scene scene = simpleScene("phong");
    scene.setPart(kinds::environment, block("environment", "studio"));
    for (const char* lamp : {"key", "fill", "rim", "top"}) {
        scene.part(kinds::environment)->parameters[std::string(lamp) + ".intensity"] = 0.0;
    }
    scene.part(kinds::environment)->parameters["directions"] = 16;
    capture(scene);
    EXPECT_EQ(std::ranges::count(renderer->report().effects, "environment/studio"), 1);
    for (const char* part : {"wall", "ceiling", "floor"}) {
        scene.part(kinds::environment)->parameters[std::string(part) + ".color"] = black;
    }
    const Image dark = capture(scene);
    EXPECT_EQ(std::ranges::count(renderer->report().effects, "environment/studio"), 0);
    const auto rows = objectRows(scene, 0, *catalog, meshSource());
    EXPECT_TRUE(std::ranges::any_of(rows, [](const EffectRow& row) {
        return row.line.reason == "It is dark. Its “Key”, “Fill”, “Rim” and “Top” are 0, and its "
                                  "“Walls”, “Ceiling” and “Floor” are black.";
    }));
    scene.setPart(kinds::environment, std::nullopt);
    EXPECT_EQ(capture(scene).pixels, dark.pixels);
}

/// Its walls are black, and the scene's own background is not.
TEST_F(NeutralSceneTest, DarkStudioBehindTheObjects_StaysIn) {
    const Block& studio = *catalog->find("environment", "studio");
    Values values;
    for (const Parameter& parameter : studio.parameters) {
        if (parameter.group == "Lamps" || parameter.type == ParameterType::Color) {
            values[parameter.id] = parameter.type == ParameterType::Color ? Value(black) : 0.0;
        }
    }
    values["tint"] = glm::dvec3(1.0);
    EXPECT_TRUE(isNeutral(studio, values));
    values["background"] = std::string("sharp");
    EXPECT_FALSE(isNeutral(studio, values));
}

/// What is refracted shows the black walls, not the background's colour.
TEST_F(NeutralSceneTest, DarkStudioBehindWhatBendsLight_StaysIn) {
    Scene scene = simpleScene("lambert");
    scene.setPart(kinds::environment, block("environment", "studio"));
    for (auto& [id, value] : scene.part(kinds::environment)->parameters) {
        if (id.ends_with(".intensity")) {
            value = 0.0;
        } else if (id.ends_with(".color")) {
            value = black;
        }
    }
    scene.part(kinds::environment)->parameters["background"] = std::string("hidden");
    const auto isIn = [&](std::size_t index) {
        const auto rows = objectRows(scene, index, *catalog, meshSource());
        return std::ranges::any_of(rows, [](const EffectRow& row) {
            return row.in && row.line.effect == "environment/studio" && row.removable;
        });
    };
    EXPECT_FALSE(isIn(0));
    Object glass = object("lambert");
    glass.material.model.parameters["diffuse.color"] = black;
    glass.material.opacity = 0.0;
    glass.material.parts["refraction"] = block("refraction", "solid-body");
    scene.objects.push_back(glass);
    EXPECT_TRUE(isIn(0));
    EXPECT_TRUE(isIn(1));
    const auto rows = objectRows(scene, 0, *catalog, meshSource());
    EXPECT_TRUE(std::ranges::none_of(
        rows, [](const EffectRow& row) { return row.within == "environment/studio"; }));
    scene.objects.front() = glass;
    scene.objects.pop_back();
    makeRenderer();
    scene.background = glm::dvec3(1.0);
    EXPECT_LT(middle(capture(scene)).x, 0.01f);
    scene.objects.front().visible = false;
    EXPECT_EQ(EffectKey::ofEnvironment(scene, *catalog), 0u);
}

TEST_F(NeutralSceneTest, FlatObjectAlone_HasNoShadowMap) {
    makeRenderer();
    Scene scene = plate();
    scene.objects[0].rotation = {70.0, 0.0, 0.0};
    const Image plain = capture(scene);
    scene.lights[0].setPart(kinds::shadows, block("shadows", "soft"));
    EXPECT_EQ(capture(scene).pixels, plain.pixels);
    EXPECT_EQ(renderer->report().shadowMaps, 0);
    const auto rows = objectRows(scene, 0, *catalog, meshSource());
    EXPECT_TRUE(std::ranges::any_of(rows, [](const EffectRow& row) {
        return row.line.reason ==
               "No shadow falls on anything: the only object is flat, and there is no ground.";
    }));
}

TEST_F(NeutralSceneTest, FlatObjectWithAnother_HasAShadowMap) {
    makeRenderer();
    Scene scene = plate();
    scene.lights[0].setPart(kinds::shadows, block("shadows", "hard"));
    scene.ambient = glm::dvec3(0.1);
    scene.objects.push_back(object("lambert"));
    capture(scene);
    EXPECT_EQ(renderer->report().shadowMaps, 1);
    const auto rows = objectRows(scene, 0, *catalog, meshSource());
    EXPECT_TRUE(std::ranges::any_of(rows, [](const EffectRow& row) {
        return row.in && row.line.effect == "shadows/hard" && row.within == "lights/directional";
    }));
}

} // namespace
} // namespace patina::neutral_values_test
