// SPDX-License-Identifier: GPL-3.0-or-later
// What the effects say of materials that refract light, and what is in their programs.
#include <algorithm>

#include "measure/choice/choices.h"
#include "shading/effects/body_index.h"
#include "shading/effects/effect_key.h"
#include "shading/effects/effect_rows.h"
#include "shading_scene.h"

namespace patina::refraction_rows_test {
namespace {

class RefractionRows : public ShadingTest {
  protected:
    void SetUp() override {
        scene_.objects.resize(1);
        glass().model = block("models", "lambert");
        glass().opacity = 0.1;
        glass().parts["refraction"] = block("refraction", "solid-body");
    }

    Material& glass() { return scene_.objects[0].material; }
    Values& values() { return glass().parts.at("refraction").parameters; }

    EffectRow row(const std::string& effect) const {
        for (const EffectRow& each : effectRows(scene_, 0, catalog())) {
            if (each.line.effect.starts_with(effect)) {
                return each;
            }
        }
        return {};
    }

    std::string text() const { return fragment(scene_.objects[0].material, scene_); }
    bool textHas(const std::string& word) const { return text().find(word) != std::string::npos; }

    BodyIndex ofGlass() const {
        const Material& glass = scene_.objects[0].material;
        return BodyIndex(glass, refractionChoice(glass, catalog()), catalog(), scene_.wavelengths);
    }

    double index() { return ofGlass().channels().y; }

    /// An object that can be seen through the first one.
    void addAnother() {
        scene_.objects.emplace_back();
        scene_.objects[1].material = material("lambert");
    }

    Scene scene_;
};

TEST_F(RefractionRows, RefractedLight_SaysHowMuchAndWhatIsSeen) {
    EXPECT_EQ(row("refraction").line.reason,
              "What passes is refracted with an index of 1.5 and shows the background's colour.");
    scene_.setPart(kinds::environment, block("environment", "studio"));
    addAnother();
    EXPECT_EQ(
        row("refraction").line.reason,
        "What passes is refracted with an index of 1.5 and shows the scene and the environment.");
}

/// A term of a user's has no code that is asked for its index, but may say it for each channel.
TEST_F(RefractionRows, OwnTermWithAnIndexForEachChannel_BendsColoursApart) {
    Catalog own = catalog();
    for (Block& term : own.blocks) {
        if (term.kind == kinds::fresnel && term.id == "conductor") {
            std::erase_if(term.parameters, [](const Parameter& parameter) {
                return parameter.role == roles::extinction;
            });
        }
    }
    const glm::dvec3 indices(1.50, 1.51, 1.53);
    glass().parts["fresnel"] = {"conductor", 1, {{"eta", indices}}};
    const BodyIndex index(glass(), refractionChoice(glass(), own), own);
    EXPECT_EQ(index.channels(), indices);
    EXPECT_TRUE(index.bendsApart());
    EXPECT_GT(index.at(450.0), index.at(550.0));
}

TEST_F(RefractionRows, WithAWayOfLayers_SaysThatItIsSorted) {
    scene_.setPart(kinds::transparency, block("transparency", "peeled"));
    EXPECT_TRUE(
        row("refraction")
            .line.reason.ends_with("Such objects are sorted, and hide what else is transparent."));
    EXPECT_FALSE(row("transparency").in);
    EXPECT_FALSE(textHas("layerWeight"));
}

TEST_F(RefractionRows, OfASolidObject_IsOut) {
    glass().opacity = 1.0;
    EXPECT_FALSE(row("refraction").in);
    EXPECT_EQ(row("refraction").line.reason, "The material's opacity is 1: nothing passes.");
    EXPECT_FALSE(textHas("efract"));
}

TEST_F(RefractionRows, OfIndexOneWithoutColour_IsOut) {
    values()["index"] = 1.0;
    EXPECT_EQ(row("refraction").line.reason, "Its index is 1 and it colours nothing.");
    EXPECT_FALSE(row("refraction").in);
    values()["tint"] = glm::dvec3(1.0, 1.0, 0.9);
    EXPECT_TRUE(row("refraction").in);
}

TEST_F(RefractionRows, SwitchedOff_IsPlainTransparency) {
    EXPECT_TRUE(row("refraction").removable);
    EXPECT_EQ(row("refraction").within, "opacity");
    const std::vector<std::string> off{"refraction/solid-body"};
    const Scene without = withoutEffects(scene_, off, catalog());
    EXPECT_EQ(fragment(without.objects[0].material, without).find("efract"), std::string::npos);
}

TEST_F(RefractionRows, Alone_LooksForNothingBehind) {
    EXPECT_FALSE(textHas("behindDepth"));
    addAnother();
    EXPECT_TRUE(textHas("behindDepth"));
}

TEST_F(RefractionRows, Pane_HasNoBack) {
    EXPECT_TRUE(textHas("refractionBack"));
    glass().parts["refraction"] = block("refraction", "thin-pane");
    EXPECT_FALSE(textHas("refractionBack"));
}

TEST_F(RefractionRows, SolidObject_KnowsNothingOfGlassBesideIt) {
    addAnother();
    const std::string with = fragment(scene_.objects[1].material, scene_);
    scene_.objects.erase(scene_.objects.begin());
    EXPECT_EQ(with, fragment(scene_.objects[0].material, scene_));
}

TEST_F(RefractionRows, Index_IsTheFresnelTerms) {
    EXPECT_DOUBLE_EQ(index(), 1.5);
    glass().parts["fresnel"] = block("fresnel", "dielectric");
    glass().parts["fresnel"].parameters["index.inside"] = 2.0;
    glass().parts["fresnel"].parameters["index.outside"] = 1.25;
    EXPECT_DOUBLE_EQ(index(), 1.6);
    glass().parts["fresnel"] = block("fresnel", "schlick");
    glass().parts["fresnel"].parameters["f0"] = glm::dvec3(1.0 / 9.0);
    EXPECT_DOUBLE_EQ(index(), 2.0);
    values()["index.from"] = std::string("own");
    EXPECT_DOUBLE_EQ(index(), 1.5);
}

TEST_F(RefractionRows, Index_IsTheModelsWhereThereIsNoFresnelTerm) {
    glass().model = block("models", "strauss");
    glass().model.parameters["index"] = 1.8;
    EXPECT_DOUBLE_EQ(index(), 1.8);
}

/// By the constants of its data sheet, N-BK7 has 1.5168 at 587.6 nm, 1.52238 at 486.1 nm and
/// 1.51432 at 656.3 nm, and so an Abbe number of 64.17.
TEST_F(RefractionRows, Index_FollowsTheConstantsOfTheFresnelTerm) {
    glass().parts["fresnel"] = block("fresnel", "dispersive");
    EXPECT_NEAR(ofGlass().at(587.56), 1.51680, 1e-5);
    EXPECT_NEAR(ofGlass().at(486.13), 1.52238, 1e-5);
    EXPECT_NEAR(ofGlass().at(656.27), 1.51432, 1e-5);
    EXPECT_NEAR(ofGlass().dispersion(), 20.0 / 64.17, 1e-3);
    EXPECT_NEAR(ofGlass().ofBlock(), 1.51680, 1e-5);
    EXPECT_EQ(row("refraction").line.reason,
              "What passes is refracted with indices of 1.516, 1.519 and 1.524 for red, green and "
              "blue, in light of 15 wavelengths, and shows the background's colour.");
    scene_.wavelengths = {656.27, 587.56, 486.13};
    EXPECT_EQ(row("refraction").line.reason,
              "What passes is refracted with indices of 1.514, 1.517 and 1.522 for red, green and "
              "blue, in light of 15 wavelengths, and shows the background's colour.");
    glass().parts["fresnel"].parameters["temperature"] = 2020.0;
    EXPECT_NEAR(ofGlass().at(587.56), 1.51680 + 3e-6 * 1998.0, 1e-5);
    glass().parts["fresnel"].parameters["index.outside"] = 1.25;
    EXPECT_NEAR(ofGlass().at(587.56), (1.51680 + 3e-6 * 1998.0) / 1.25, 1e-5);
    values()["index.from"] = std::string("own");
    EXPECT_DOUBLE_EQ(index(), 1.5);
    EXPECT_EQ(ofGlass().dispersion(), 0.0);
    EXPECT_FALSE(textHas("WAVELENGTH"));
}

TEST_F(RefractionRows, Index_IsThatBelowAFilmWhereItDoesNotAbsorb) {
    glass().parts["fresnel"] = block("fresnel", "thin-film");
    EXPECT_DOUBLE_EQ(index(), 1.52);
    EXPECT_FALSE(textHas("WAVELENGTH"));
    Values& film = glass().parts["fresnel"].parameters;
    film["eta"] = glm::dvec3(1.6, 1.7, 1.9);
    EXPECT_TRUE(textHas("#define WAVELENGTHS 15\n"));
    EXPECT_DOUBLE_EQ(ofGlass().at(srgbWavelengths.x + 50.0), 1.6);
    EXPECT_DOUBLE_EQ(ofGlass().at(0.5 * (srgbWavelengths.y + srgbWavelengths.z)), 1.8);
    film["k"] = glm::dvec3(3.0);
    EXPECT_DOUBLE_EQ(index(), 1.5);
}

/// The scene's green, since a pane leaves light in its old direction.
TEST_F(RefractionRows, Pane_HasOneRayByTheConstants) {
    glass().parts["fresnel"] = block("fresnel", "dispersive");
    glass().parts["refraction"] = block("refraction", "thin-pane");
    EXPECT_FALSE(textHas("WAVELENGTH"));
    EXPECT_DOUBLE_EQ(ofGlass().ofBlock(), ofGlass().at(srgbWavelengths.y));
}

TEST_F(RefractionRows, MirroredByATerm_SaysSo) {
    glass().parts["fresnel"] = block("fresnel", "thin-film");
    EXPECT_EQ(row("refraction").line.reason,
              "What passes is refracted with an index of 1.52 and shows the background's colour. "
              "What its surface mirrors is by the Fresnel term.");
}

TEST_F(RefractionRows, ThatBendsAllAlike_KnowsNoWavelengths) {
    const std::string plain = text();
    for (const char* level : {"15", "9", "5", "3"}) {
        glass().accuracy["wavelengths"] = level;
        EXPECT_EQ(text(), plain) << level;
    }
    EXPECT_FALSE(textHas("forWavelength"));
    EXPECT_FALSE(textHas("WAVELENGTH"));
}

TEST_F(RefractionRows, ThatBendsColoursApart_HasAsManyRaysAsAreChosen) {
    values()["dispersion"] = 0.3;
    EXPECT_TRUE(textHas("#define WAVELENGTHS 15\n"));
    for (const char* level : {"15", "9", "5", "3"}) {
        glass().accuracy["wavelengths"] = level;
        EXPECT_TRUE(textHas(std::string("#define WAVELENGTHS ") + level + '\n')) << level;
    }
    glass().accuracy["wavelengths"] = "7"; // which is not among them
    EXPECT_TRUE(textHas("#define WAVELENGTHS 15\n"));
}

TEST_F(RefractionRows, Wavelengths_AreAChoiceWhereColoursBendApart) {
    const auto offers = [&] {
        const std::vector<Choice> choices = materialChoices(scene_, 0, catalog());
        return std::ranges::count(choices, "refraction.wavelengths", &Choice::id) > 0;
    };
    EXPECT_FALSE(offers());
    values()["dispersion"] = 0.3;
    EXPECT_TRUE(offers());
}

TEST_F(RefractionRows, Key_DiffersExactlyWhereTheTextDoes) {
    std::vector<Material> materials(14, glass());
    materials[1].opacity = 1.0;
    materials[2].parts["refraction"].parameters["index"] = 1.0;
    materials[3].parts["refraction"].parameters["index"] = 1.7;
    materials[4].parts["refraction"].parameters["dispersion"] = 0.3;
    materials[5].parts["refraction"] = block("refraction", "thin-pane");
    materials[6].parts.clear();
    materials[7].parts["refraction"].parameters["absorption.distance"] = 3.0;
    materials[8].accuracy["wavelengths"] = "3";
    materials[9] = materials[4];
    materials[9].accuracy["wavelengths"] = "3";
    materials[10] = materials[4];
    materials[10].accuracy["wavelengths"] = "9";
    materials[11].parts["fresnel"] = block("fresnel", "dispersive");
    materials[12].parts["fresnel"] = block("fresnel", "thin-film");
    materials[13] = materials[12];
    materials[13].parts["refraction"].parameters["index.from"] = std::string("own");
    for (const Material& a : materials) {
        for (const Material& b : materials) {
            EXPECT_EQ(EffectKey::ofMaterial(a, catalog()) == EffectKey::ofMaterial(b, catalog()),
                      fragment(a, scene_) == fragment(b, scene_));
        }
    }
}

TEST_F(RefractionRows, SceneKey_KnowsWhetherThereIsSomethingBehind) {
    EffectKey keys;
    const std::uint64_t alone = keys.ofScene(scene_, catalog());
    addAnother();
    EXPECT_NE(keys.ofScene(scene_, catalog()), alone);
    scene_.objects[1].visible = false;
    EXPECT_EQ(keys.ofScene(scene_, catalog()), alone);
}

} // namespace
} // namespace patina::refraction_rows_test
