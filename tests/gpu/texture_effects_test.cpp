// SPDX-License-Identifier: GPL-3.0-or-later
// Which images are in a program, and that nothing of them is where there are none.
#include "shading/effects/effect_key.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"
#include "shading_scene.h"

namespace patina::texture_effects_test {
namespace {

class TextureEffects : public ShadingTest {
  protected:
    static Material withImage(const std::string& model, const std::string& key) {
        Material made = material(model);
        made.textures[key] = textureUse(key, "/image.png");
        return made;
    }
};

TEST_F(TextureEffects, UnboundMaterial_HasNoSamplerAndNoCoordinates) {
    const auto program = surfaceProgram(effectSet(material("phong"), {}, catalog()), catalog());
    ASSERT_TRUE(program);
    EXPECT_EQ(program->fragment.text.find("sampler"), std::string::npos);
    EXPECT_EQ(program->vertex.text.find("uv"), std::string::npos);
}

TEST_F(TextureEffects, BoundImage_IsOneSampler) {
    const std::string text = fragment(withImage("phong", "diffuse.color"), {});
    EXPECT_NE(text.find("uniform sampler2D image0;"), std::string::npos);
    EXPECT_EQ(text.find("image1"), std::string::npos);
}

TEST_F(TextureEffects, ImageOfColor_BringsNoReliefAndNoCutOut) {
    const std::string text = fragment(withImage("phong", "diffuse.color"), {});
    EXPECT_EQ(text.find("normalMapped"), std::string::npos);
    EXPECT_EQ(text.find("heightMapped"), std::string::npos);
    EXPECT_EQ(text.find("discard"), std::string::npos);
}

TEST_F(TextureEffects, EvenCoordinates_AreForHeightsAlone) {
    for (const bool isHeight : {false, true}) {
        const Material made = withImage("phong", isHeight ? "height" : "normal");
        const auto program = surfaceProgram(effectSet(made, {}, catalog()), catalog());
        ASSERT_TRUE(program);
        EXPECT_EQ(program->vertex.text.find("evenUv") != std::string::npos, isHeight);
        EXPECT_EQ(program->fragment.text.find("evenUv") != std::string::npos, isHeight);
    }
}

TEST_F(TextureEffects, EveryValueThatTakesAnImage_GivesAProgramThatAssembles) {
    for (const Block* model : catalog().ofKind("models")) {
        for (const Parameter& parameter : model->parameters) {
            if (!parameter.textureChannels.empty()) {
                const std::string text = fragment(withImage(model->id, parameter.id), {});
                EXPECT_NE(text.find("imaged(model." + fieldName(parameter.id)), std::string::npos)
                    << model->id << ' ' << parameter.id;
            }
        }
    }
}

TEST_F(TextureEffects, ImageOfAPart_ChangesTheFieldInTheSlot) {
    Material matte = withImage("lambert", "specular.gloss");
    matte.parts["specular"] = block("specular", "gaussian");
    EXPECT_NE(fragment(matte, {}).find("model.specular.gloss = imaged("), std::string::npos);
}

TEST_F(TextureEffects, ImageOfABlendedFresnelTerm_ChangesItsOwnStruct) {
    Material matte = withImage("lambert", "fresnel.f0");
    matte.parts["fresnel"] = block("fresnel", "schlick");
    EXPECT_NE(fragment(matte, {}).find("blend.f0 = imaged("), std::string::npos);
}

TEST_F(TextureEffects, ImageOfTheGlow_LightsABlackOne) {
    EXPECT_EQ(effectSet(withImage("lambert", "emissive.color"), {}, catalog()).emission.size(), 1u);
}

TEST_F(TextureEffects, ValueThatTheModelLacks_IsLeftOutWithAReason) {
    EXPECT_EQ(whyNoTexture(withImage("lambert", "roughness")),
              "The material has no such value now.");
}

TEST_F(TextureEffects, ValueThatTakesNoImage_IsLeftOutWithAReason) {
    EXPECT_EQ(whyNoTexture(withImage("ward", "tangent.angle")), "The value takes no image.");
}

TEST_F(TextureEffects, StrengthZero_IsLeftOutWithAReason) {
    Material phong = withImage("phong", "diffuse.color");
    phong.textures.begin()->second.strength = 0.0;
    EXPECT_EQ(whyNoTexture(phong), "Its strength is 0.");
}

TEST_F(TextureEffects, SwitchedOff_IsLeftOutWithAReason) {
    Material phong = withImage("phong", "diffuse.color");
    phong.textures.begin()->second.enabled = false;
    EXPECT_EQ(whyNoTexture(phong), "It is switched off.");
}

TEST_F(TextureEffects, MoreImagesThanUnits_AreLeftOutWithAReason) {
    Material ward = material("ward");
    for (const char* key : {"diffuse.color", "emissive.color", "gloss", "height", "normal",
                            "opacity", "roughness", "roughness.x", "roughness.y"}) {
        ward.textures[key] = textureUse(key, "/image.png");
    }
    EXPECT_EQ(effectSet(ward, {}, catalog()).textures.size(), maxTextures);
    EXPECT_EQ(whyNoTexture(ward), "A material shows 8 images at most.");
}

TEST_F(TextureEffects, OpacityAfterTooManyImages_StaysSinceShadowsGoByIt) {
    Material lafortune = material("lafortune");
    for (const char* key : {"diffuse.color", "emissive.color", "gloss", "height", "lobe1.color",
                            "lobe2.color", "lobe3.color", "normal", "opacity"}) {
        lafortune.textures[key] = textureUse(key, "/image.png");
    }
    const auto textures = effectSet(lafortune, {}, catalog()).textures;
    ASSERT_EQ(textures.size(), maxTextures);
    EXPECT_EQ(textures.back().role, TextureRole::Opacity);
}

TEST_F(TextureEffects, Key_StaysWhenOnlyDataChange) {
    Material phong = withImage("phong", "diffuse.color");
    const std::uint64_t before = EffectKey::ofMaterial(phong, catalog());
    TextureUse& use = phong.textures.begin()->second;
    use.file = "/other.png";
    use.scale = {2.0, 3.0};
    use.wrap = TextureWrap::Mirror;
    use.strength = 0.5;
    EXPECT_EQ(EffectKey::ofMaterial(phong, catalog()), before);
    EXPECT_EQ(effectSet(phong, {}, catalog()),
              effectSet(withImage("phong", "diffuse.color"), {}, catalog()));
}

TEST_F(TextureEffects, Key_ChangesWithChannelAndMode) {
    const Material before = withImage("phong", "diffuse.color");
    Material other = before;
    other.textures.begin()->second.channel = TextureChannel::Green;
    EXPECT_NE(EffectKey::ofMaterial(other, catalog()), EffectKey::ofMaterial(before, catalog()));
    other = before;
    other.textures.begin()->second.mode = TextureMode::Add;
    EXPECT_NE(EffectKey::ofMaterial(other, catalog()), EffectKey::ofMaterial(before, catalog()));
}

TEST_F(TextureEffects, OpacityImage_IsTransparentUnlessItCutsOut) {
    Material leaf = withImage("lambert", "opacity");
    EXPECT_TRUE(isTransparent(leaf, catalog()));
    leaf.textures.begin()->second.cutOut = true;
    EXPECT_FALSE(isTransparent(leaf, catalog()));
}

} // namespace
} // namespace patina::texture_effects_test
