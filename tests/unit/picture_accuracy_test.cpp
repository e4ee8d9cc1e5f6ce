// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/picture_choice_text.h"

#include <gtest/gtest.h>

#include "catalog/json_text.h"
#include "scene/picture_accuracy_file.h"

namespace patina::picture_accuracy_test {
namespace {

TEST(PictureAccuracy, NewOne_DrawsAsAlways) {
    const PictureAccuracy accuracy;
    EXPECT_EQ(accuracy.samples(), 4);
    EXPECT_FALSE(accuracy.lightsAtVertices());
    EXPECT_FALSE(accuracy.leavesNormals());
    EXPECT_FALSE(accuracy.fogsAtVertices());
    EXPECT_EQ(accuracy.scale(), 1.0);
    EXPECT_FALSE(accuracy.hasWholeNumbers());
}

TEST(PictureAccuracy, Scale_IsAQuarterLessPerLevel) {
    PictureAccuracy accuracy;
    accuracy.choose(PictureChoice::Scale, *pictureChoiceText("scale")->level("three-quarters"));
    EXPECT_EQ(accuracy.scale(), 0.75);
    accuracy.choose(PictureChoice::Scale, *pictureChoiceText("scale")->level("half"));
    EXPECT_EQ(accuracy.scale(), 0.5);
}

TEST(PictureAccuracy, LevelThatThereIsNot_BecomesTheLast) {
    PictureAccuracy accuracy;
    accuracy.choose(PictureChoice::Scale, 200);
    EXPECT_EQ(accuracy.level(PictureChoice::Scale), 2u);
}

/// A scene file's accuracy, and the notes about it.
struct ReadAccuracy {
    explicit ReadAccuracy(const std::string& text)
        : document(*parseJson("{\"accuracy\": " + text + "}", "a file")) {
        Errors errors;
        JsonReader reader(document, "", errors);
        readPictureAccuracy(reader, scene, notes);
        EXPECT_EQ(errors, Errors());
    }
    LocatedJson document;
    Scene scene;
    Errors notes;
};

TEST(PictureAccuracyFile, Levels_ComeBack) {
    const ReadAccuracy read(R"({"lighting": "vertex", "scale": "half", "later": 1})");
    EXPECT_TRUE(read.scene.accuracy.lightsAtVertices());
    EXPECT_EQ(read.scene.accuracy.scale(), 0.5);
    nlohmann::json written = read.scene.unknown;
    writePictureAccuracy(written, read.scene.accuracy);
    EXPECT_EQ(written, read.document.value);
}

TEST(PictureAccuracyFile, UnknownLevel_IsNotedAtItsPlace) {
    const ReadAccuracy read(R"({"fog": "thick"})");
    EXPECT_EQ(read.scene.accuracy, PictureAccuracy());
    ASSERT_EQ(read.notes.size(), 1u);
    EXPECT_NE(read.notes[0].expected.find("vertex"), std::string::npos);
}

TEST(PictureChoiceText, EveryChoice_HasOneAtItsPlace) {
    const auto texts = pictureChoiceTexts();
    ASSERT_EQ(texts.size(), pictureChoices);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        EXPECT_EQ(static_cast<std::size_t>(texts[i].choice), i);
        EXPECT_EQ(pictureChoiceText(texts[i].id), &texts[i]);
    }
}

TEST(PictureChoiceText, UnknownNames_AreNothing) {
    EXPECT_EQ(pictureChoiceText("colour"), nullptr);
    EXPECT_FALSE(pictureChoiceText("fog")->level("thick"));
}

} // namespace
} // namespace patina::picture_accuracy_test
