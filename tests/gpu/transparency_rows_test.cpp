// SPDX-License-Identifier: GPL-3.0-or-later
// What the effects say of objects that are transparent, and what is in their programs.

#include "shading/effects/effect_key.h"
#include "shading/effects/effect_rows.h"
#include "shading_scene.h"

namespace patina::transparency_rows_test {
namespace {

class TransparencyRows : public ShadingTest {
  protected:
    void SetUp() override {
        scene_.objects.resize(3);
        for (Object& object : scene_.objects) {
            object.material = material("lambert");
            object.material.opacity = 0.5;
        }
    }

    /// The row whose name begins so.
    EffectRow row(const std::string& effect) const {
        for (const EffectRow& each : effectRows(scene_, 0, catalog())) {
            if (each.line.effect.starts_with(effect)) {
                return each;
            }
        }
        return {};
    }

    void choose(const std::string& id) {
        scene_.setPart(kinds::transparency, block("transparency", id));
    }

    std::string text(std::size_t object) const {
        return fragment(scene_.objects[object].material, scene_);
    }

    Scene scene_;
};

TEST_F(TransparencyRows, WithoutAChoice_AreSorted) {
    const EffectRow found = row("transparency");
    EXPECT_TRUE(found.in);
    EXPECT_EQ(found.line.detail, "sorted");
    EXPECT_EQ(found.line.reason, "3 objects are transparent: each is blended over what is behind "
                                 "it, far ones first.");
}

TEST_F(TransparencyRows, Chosen_SaysHowAndOfHowMany) {
    choose("peeled");
    scene_.objects[1].visible = false;
    EXPECT_EQ(row("transparency").line.effect, "transparency/peeled");
    EXPECT_EQ(row("transparency").line.reason,
              "2 objects are transparent: the layers of each pixel are put in their order.");
    choose("weighted");
    EXPECT_EQ(row("transparency").line.reason,
              "2 objects are transparent: all layers of a pixel are mixed at once.");
}

TEST_F(TransparencyRows, OfASolidObject_SayThatItIsOpaque) {
    choose("peeled");
    scene_.objects[0].material.opacity = 1.0;
    EXPECT_FALSE(row("transparency").in);
    EXPECT_EQ(row("transparency").line.reason, "The object is opaque.");
}

TEST_F(TransparencyRows, WhereAllIsSolid_SayThatTheChoiceIsLeftOut) {
    choose("peeled");
    for (Object& object : scene_.objects) {
        object.material.opacity = 1.0;
    }
    EXPECT_FALSE(row("transparency").in);
    EXPECT_EQ(row("transparency").line.reason, "No object is transparent.");
}

TEST_F(TransparencyRows, OfAnUnknownKind_AreSorted) {
    scene_.parts["transparency"].id = "magic";
    EXPECT_EQ(row("transparency").line.detail, "sorted");
}

TEST_F(TransparencyRows, Chosen_ComesAlongWithTheOpacity) {
    choose("weighted");
    EXPECT_TRUE(row("transparency").removable);
    EXPECT_EQ(row("transparency").within, "opacity");
}

TEST_F(TransparencyRows, OfSolidObjects_AreNotInTheText) {
    scene_.objects[0].material.opacity = 1.0;
    const std::string before = text(0);
    for (const char* id : {"peeled", "weighted"}) {
        choose(id);
        EXPECT_EQ(text(0), before);
        EXPECT_NE(text(1).find("ransparency"), std::string::npos);
    }
}

TEST_F(TransparencyRows, WithoutAChoice_AreNotInTheText) {
    EXPECT_EQ(text(0).find("ransparency"), std::string::npos);
    EXPECT_EQ(text(0).find("ayer"), std::string::npos);
}

TEST_F(TransparencyRows, OneKind_HasNothingOfTheOtherInTheText) {
    choose("peeled");
    EXPECT_EQ(text(0).find("weighted"), std::string::npos);
    EXPECT_EQ(text(0).find("storedShare"), std::string::npos);
    choose("weighted");
    EXPECT_EQ(text(0).find("peeled"), std::string::npos);
}

TEST_F(TransparencyRows, Key_DiffersExactlyWhereTheEffectDoes) {
    std::vector<Scene> scenes{scene_};
    for (const char* id : {"peeled", "weighted"}) {
        choose(id);
        scenes.push_back(scene_);
        scenes.push_back(scene_);
        for (Object& object : scenes.back().objects) {
            object.material.opacity = 1.0;
        }
    }
    choose("peeled");
    scene_.part(kinds::transparency)->parameters["layers"] = 3;
    scenes.push_back(scene_);
    EffectKey keys;
    for (const Scene& a : scenes) {
        for (const Scene& b : scenes) {
            EXPECT_EQ(keys.ofScene(a, catalog()) == keys.ofScene(b, catalog()),
                      sceneEffects(a, catalog()).transparency ==
                          sceneEffects(b, catalog()).transparency);
        }
    }
}

} // namespace
} // namespace patina::transparency_rows_test
