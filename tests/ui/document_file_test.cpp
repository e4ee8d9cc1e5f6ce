// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include <gtest/gtest.h>

#include "document/compare_edits.h"
#include "document/scene_edits.h"
#include "scene/scene_file.h"
#include "ui/fixtures.h"

namespace patina::tests::document_file_test {

namespace {

/// Everything a file holds, as text: numbers count as the floats they are.
std::string written(const DocumentState& state) {
    const std::string second = state.second ? writeJson(toJson(*state.second)) : "";
    return writeJson(toJson(state.scene, "/")) + second;
}

struct DocumentFile_ : testing::Test {
    FixtureDocument fixture;
    Document& document = fixture.document;
    TemporaryFolder folder;
    std::vector<std::string> messages;

    DocumentFile_() {
        QObject::connect(&fixture.files, &DocumentFiles::message,
                         [this](const Error& error) { messages.push_back(error.text()); });
    }

    /// a.patina.json as a newer version of Patina would write it.
    std::string writeFuturePreset() {
        EXPECT_TRUE(fixture.files.savePreset(folder / "a.patina.json", Side::A));
        std::string future = readFile(folder / "a.patina.json");
        const std::string version = "\n  \"version\": 1";
        future.replace(future.find(version), version.size(), "\n  \"version\": 99");
        writeFile(folder / "a.patina.json", future);
        return future;
    }
};

} // namespace

TEST_F(DocumentFile_, SavedScene_OpensAsItWas) {
    document.setValue(fixture.model(), "roughness", 0.75);
    fixture.comparison.setComparing(true);
    document.setValue(pathOf(kinds::models, 0, Side::B), "roughness", 0.25);
    ASSERT_TRUE(fixture.files.saveScene(folder / "a.patina-scene.json"));
    const std::string saved = written(document.state());
    fixture.files.startFrom(Scene());
    ASSERT_TRUE(fixture.files.openScene(folder / "a.patina-scene.json"));
    EXPECT_EQ(written(document.state()), saved);
    EXPECT_EQ(messages, std::vector<std::string>());
}

TEST_F(DocumentFile_, PresetAfterAChangeOfModel_HoldsNoValuesOfTheFormerOne) {
    document.setValue(fixture.model(), "roughness", 0.75);
    document.setModel(Side::A, "second");
    ASSERT_TRUE(fixture.files.savePreset(folder / "a.patina.json", Side::A));
    EXPECT_EQ(readFile(folder / "a.patina.json").find("roughness"), std::string::npos);
    document.setModel(Side::A, "first");
    EXPECT_EQ(fixture.number("roughness"), 0.75); // the document has it still
}

TEST_F(DocumentFile_, PresetThatKeepsParkedValues_HasThemWhenItIsOpened) {
    document.setValue(fixture.model(), "roughness", 0.75);
    document.setModel(Side::A, "second");
    fixture.files.setKeepsParked(true);
    ASSERT_TRUE(fixture.files.savePreset(folder / "a.patina.json", Side::A));
    fixture.files.startFrom(fixtureScene(*fixture.blocks.catalog()));
    ASSERT_TRUE(fixture.files.openPreset(folder / "a.patina.json"));
    document.setModel(Side::A, "first");
    EXPECT_EQ(fixture.number("roughness"), 0.75);
}

TEST_F(DocumentFile_, PresetThatHasParkedValues_KeepsThemWhenItIsWrittenAnew) {
    document.setValue(fixture.model(), "roughness", 0.75);
    document.setModel(Side::A, "second");
    fixture.files.setKeepsParked(true);
    ASSERT_TRUE(fixture.files.savePreset(folder / "a.patina.json", Side::A));
    fixture.files.setKeepsParked(false);
    ASSERT_TRUE(fixture.files.savePreset(folder / "a.patina.json", Side::A));
    EXPECT_NE(readFile(folder / "a.patina.json").find("roughness"), std::string::npos);
}

TEST_F(DocumentFile_, CopyOfUnsavedWork_HasTheValuesOfTheFormerModel) {
    document.setValue(fixture.model(), "roughness", 0.75);
    document.setModel(Side::A, "second");
    EXPECT_EQ(fixture.files.sceneToRecover().objects.front().material.parked["roughness"], 0.75);
}

TEST_F(DocumentFile_, SideB_StaysOnItsObject) {
    addObject(document, document.scene().objects.front());
    fixture.comparison.setComparing(true);
    document.setValue(pathOf(kinds::models, 1, Side::B), "roughness", 0.25);
    ASSERT_TRUE(fixture.files.saveScene(folder / "a.patina-scene.json"));
    Scene shown = document.scene(Side::B);
    shown.name = "a"; // as the file
    fixture.files.startFrom(Scene());
    ASSERT_TRUE(fixture.files.openScene(folder / "a.patina-scene.json"));
    EXPECT_EQ(document.selection().object(), 1);
    EXPECT_EQ(document.scene(Side::B), shown);
}

TEST_F(DocumentFile_, FourSides_AreSavedWithTheScene) {
    fixture.comparison.setSideCount(4);
    document.setValue(pathOf(kinds::models, 0, Side::B), "roughness", 0.25);
    document.setValue(pathOf(kinds::models, 0, Side::D), "roughness", 0.75);
    const DocumentState before = document.state();
    ASSERT_TRUE(fixture.files.saveScene(folder / "a.patina-scene.json"));
    fixture.files.startFrom(Scene());
    ASSERT_TRUE(fixture.files.openScene(folder / "a.patina-scene.json"));
    EXPECT_EQ(document.state().second, before.second);
    EXPECT_EQ(document.state().further, before.further);
    EXPECT_EQ(document.scene().extras.dump().find("compare"), std::string::npos);
}

TEST_F(DocumentFile_, WhatViewsHaveOfTheirOwn_IsSavedWithTheScene) {
    fixture.comparison.setSideCount(4);
    OwnView own;
    own.exposure = -1.5;
    own.switchedOff = {"one", "other"};
    setOwnView(document, Side::A, own, "");
    own.hasEnvironment = true;
    setOwnView(document, Side::C, own, "");
    const DocumentState before = document.state();
    ASSERT_TRUE(fixture.files.saveScene(folder / "a.patina-scene.json"));
    fixture.files.startFrom(Scene());
    ASSERT_TRUE(fixture.files.openScene(folder / "a.patina-scene.json"));
    EXPECT_EQ(document.state().ownViews, before.ownViews);
    EXPECT_EQ(document.scene().extras.dump().find("compare"), std::string::npos);
}

TEST_F(DocumentFile_, OwnViewsOfAnotherShape_AreKeptAndLinked) {
    fixture.comparison.setComparing(true);
    OwnView own;
    own.exposure = 1.0;
    setOwnView(document, Side::B, own, "");
    ASSERT_TRUE(fixture.files.saveScene(folder / "a.patina-scene.json"));
    std::string file = readFile(folder / "a.patina-scene.json");
    const std::size_t at = file.find("\"exposure\": 1.0", file.find("\"compareViews\""));
    ASSERT_NE(at, std::string::npos);
    file.replace(at, 15, "\"exposure\": \"bright\"");
    writeFile(folder / "a.patina-scene.json", file);
    ASSERT_TRUE(fixture.files.openScene(folder / "a.patina-scene.json"));
    EXPECT_TRUE(document.state().ownViews[1].isLinked());
}

TEST_F(DocumentFile_, SideBOfAnObjectThatIsNotThere_IsOnTheFirst) {
    fixture.comparison.setComparing(true);
    ASSERT_TRUE(fixture.files.saveScene(folder / "a.patina-scene.json"));
    std::string file = readFile(folder / "a.patina-scene.json");
    const std::string named = "\"compareObject\": 0";
    ASSERT_NE(file.find(named), std::string::npos);
    file.replace(file.find(named), named.size(), "\"compareObject\": 1e99");
    writeFile(folder / "a.patina-scene.json", file);
    ASSERT_TRUE(fixture.files.openScene(folder / "a.patina-scene.json"));
    EXPECT_EQ(document.selection().object(), 0);
}

TEST_F(DocumentFile_, PresetOfTheSecondObject_IsSavedFromIt) {
    addObject(document, document.scene().objects.front());
    ASSERT_TRUE(fixture.files.savePreset(folder / "a.patina.json", Side::A));
    ASSERT_TRUE(fixture.files.openPreset(folder / "a.patina.json"));
    document.setValue(pathOf(kinds::models, 1), "roughness", 0.75);
    document.selection().setObject(0);
    ASSERT_TRUE(fixture.files.save());
    EXPECT_NE(readFile(folder / "a.patina.json").find("0.75"), std::string::npos);
}

TEST_F(DocumentFile_, SavedScene_IsNotModified) {
    document.setValue(fixture.model(), "roughness", 0.75);
    EXPECT_TRUE(document.isModified());
    fixture.files.saveScene(folder / "a.patina-scene.json");
    EXPECT_FALSE(document.isModified());
    document.undoStack().undo();
    EXPECT_TRUE(document.isModified());
}

TEST_F(DocumentFile_, SavedPreset_OpensAsItWas) {
    document.setValue(fixture.model(), "roughness", 0.75);
    const std::string saved = writeJson(toJson(*document.material(Side::A)));
    ASSERT_TRUE(fixture.files.savePreset(folder / "a.patina.json", Side::A));
    EXPECT_FALSE(document.isModified());
    document.undoStack().undo();
    ASSERT_TRUE(fixture.files.openPreset(folder / "a.patina.json"));
    EXPECT_EQ(writeJson(toJson(*document.material(Side::A))), saved);
}

TEST_F(DocumentFile_, SavedPresetOfAChangedScene_StaysModified) {
    document.setValue(document.selection().currentPath(kinds::lights), "intensity", 5.0);
    ASSERT_TRUE(fixture.files.savePreset(folder / "a.patina.json", Side::A));
    EXPECT_TRUE(document.isModified());
}

/// Its lights stay, and closing must ask about them.
TEST_F(DocumentFile_, PresetOpenedInAChangedScene_LeavesThatModified) {
    ASSERT_TRUE(fixture.files.savePreset(folder / "a.patina.json", Side::A));
    document.setValue(fixture.model(), "roughness", 0.75);
    ASSERT_TRUE(fixture.files.openPreset(folder / "a.patina.json"));
    EXPECT_FALSE(document.isModified());
    document.setValue(document.selection().currentPath(kinds::lights), "intensity", 5.0);
    ASSERT_TRUE(fixture.files.openPreset(folder / "a.patina.json"));
    EXPECT_TRUE(document.isModified());
    EXPECT_TRUE(fixture.files.outgrewPreset());
}

TEST_F(DocumentFile_, SecondSave_WritesTheSameFile) {
    fixture.files.saveScene(folder / "a.patina-scene.json");
    document.setValue(fixture.model(), "roughness", 0.75);
    ASSERT_TRUE(fixture.files.save());
    EXPECT_NE(readFile(folder / "a.patina-scene.json").find("0.75"), std::string::npos);
}

TEST_F(DocumentFile_, UntitledDocument_DoesNotSave) {
    EXPECT_FALSE(fixture.files.save());
}

TEST_F(DocumentFile_, SceneSavedUnderAnotherName_IsCalledAsItsFile) {
    ASSERT_TRUE(fixture.files.saveScene(folder / "v1.2 night.patina-scene.json"));
    EXPECT_EQ(document.scene().name, "v1.2 night");
    document.setValue(fixture.model(), "roughness", 0.75);
    ASSERT_TRUE(fixture.files.save());
    fixture.files.startFrom(Scene());
    ASSERT_TRUE(fixture.files.openScene(folder / "v1.2 night.patina-scene.json"));
    EXPECT_EQ(document.scene().name, "v1.2 night");
}

TEST_F(DocumentFile_, SceneSavedWhereItCannotBe_KeepsItsName) {
    const std::string name = document.scene().name;
    EXPECT_FALSE(fixture.files.saveScene(folder / "missing" / "b.patina-scene.json"));
    EXPECT_EQ(document.scene().name, name);
}

TEST_F(DocumentFile_, PresetSavedWhereItCannotBe_KeepsItsName) {
    const Material before = *document.material(Side::A);
    const int steps = fixture.steps();
    EXPECT_FALSE(fixture.files.savePreset(folder / "missing" / "b.patina.json", Side::A, "b"));
    EXPECT_EQ(*document.material(Side::A), before);
    EXPECT_EQ(fixture.steps(), steps);
    EXPECT_FALSE(document.isModified());
}

TEST_F(DocumentFile_, MaterialExportedOutOfAScene_IsNotCalledOtherwiseThere) {
    ASSERT_TRUE(fixture.files.saveScene(folder / "a.patina-scene.json"));
    const Material before = *document.material(Side::A);
    ASSERT_TRUE(fixture.files.savePreset(folder / "b.patina.json", Side::A, "b"));
    EXPECT_EQ(*document.material(Side::A), before);
    EXPECT_FALSE(document.isModified());
    ASSERT_TRUE(fixture.files.openPreset(folder / "b.patina.json"));
    EXPECT_EQ(document.material(Side::A)->name, "b");
}

TEST_F(DocumentFile_, DroppedPreset_IsOneStep) {
    fixture.files.savePreset(folder / "a.patina.json", Side::A);
    document.setValue(fixture.model(), "roughness", 0.75);
    const int steps = fixture.steps();
    ASSERT_TRUE(fixture.files.applyPreset(folder / "a.patina.json", Side::A));
    EXPECT_EQ(fixture.steps(), steps + 1);
    EXPECT_EQ(fixture.number("roughness"), 0.5);
}

TEST_F(DocumentFile_, PresetDroppedOnB_StartsComparing) {
    fixture.files.savePreset(folder / "a.patina.json", Side::A);
    ASSERT_TRUE(fixture.files.applyPreset(folder / "a.patina.json", Side::B));
    EXPECT_TRUE(document.isComparing());
}

TEST_F(DocumentFile_, RecoveredWork_IsSavedToTheFileItBelongsTo) {
    document.setValue(fixture.model(), "roughness", 0.75);
    ASSERT_TRUE(fixture.files.saveScene(folder / "copy.patina-scene.json"));
    fixture.files.startFrom(Scene());
    const DocumentFile origin{DocumentFile::Kind::Scene, folder / "a.patina-scene.json", false};
    ASSERT_TRUE(fixture.files.recover(folder / "copy.patina-scene.json", origin));
    EXPECT_TRUE(document.isModified());
    ASSERT_TRUE(fixture.files.save());
    EXPECT_NE(readFile(folder / "a.patina-scene.json").find("0.75"), std::string::npos);
}

TEST_F(DocumentFile_, RecoveredPreset_StaysModifiedWhenMoreThanThePresetChanged) {
    document.setValue(document.selection().currentPath(kinds::lights), "intensity", 5.0);
    ASSERT_TRUE(fixture.files.saveScene(folder / "copy.patina-scene.json"));
    document.undoStack().undo();
    const DocumentFile origin{DocumentFile::Kind::Preset, folder / "a.patina.json", false};
    ASSERT_TRUE(fixture.files.recover(folder / "copy.patina-scene.json", origin));
    ASSERT_TRUE(fixture.files.save());
    EXPECT_TRUE(document.isModified());
}

TEST_F(DocumentFile_, PresetWithAChangedLight_IsOutgrown) {
    ASSERT_TRUE(fixture.files.savePreset(folder / "a.patina.json", Side::A));
    document.setValue(fixture.model(), "roughness", 0.75);
    EXPECT_FALSE(fixture.files.outgrewPreset());
    document.setValue(document.selection().currentPath(kinds::lights), "intensity", 5.0);
    EXPECT_TRUE(fixture.files.outgrewPreset());
}

TEST_F(DocumentFile_, BadFile_ChangesNothingAndSaysSo) {
    const DocumentState before = document.state();
    writeFile(folder / "a.patina-scene.json", "{\"format\": ");
    EXPECT_FALSE(fixture.files.openScene(folder / "a.patina-scene.json"));
    EXPECT_EQ(document.state(), before);
    EXPECT_EQ(messages.size(), 1u);
}

TEST_F(DocumentFile_, MissingFolder_SaysSo) {
    EXPECT_FALSE(fixture.files.saveScene(folder / "missing" / "a.patina-scene.json"));
    EXPECT_EQ(messages.size(), 1u);
}

TEST_F(DocumentFile_, PresetFromTheFuture_IsNotSavedOver) {
    const std::string future = writeFuturePreset();
    ASSERT_TRUE(fixture.files.openPreset(folder / "a.patina.json"));
    EXPECT_TRUE(fixture.files.file().readOnly);
    EXPECT_FALSE(fixture.files.save());
    EXPECT_EQ(readFile(folder / "a.patina.json"), future);
}

TEST_F(DocumentFile_, ImageOutsideTheFolder_IsSaidWhenItIsSaved) {
    Material material = *document.material(Side::A);
    material.textures["normal"] = textureUse("normal", (folder / "far" / "a.png").string());
    document.replaceMaterial(Side::A, material, "Test");
    std::filesystem::create_directories(folder / "near");
    ASSERT_TRUE(fixture.files.savePreset(folder / "near" / "a.patina.json", Side::A));
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages.front().find("far/a.png"), std::string::npos) << messages.front();
}

TEST_F(DocumentFile_, PresetFromTheFutureUnderAnotherName_IsNotSavedOver) {
    const std::string future = writeFuturePreset();
    std::filesystem::create_symlink(folder.path(), folder / "same");
    ASSERT_TRUE(fixture.files.openPreset(folder / "same" / "a.patina.json"));
    EXPECT_FALSE(fixture.files.savePreset(folder / "a.patina.json", Side::A));
    EXPECT_EQ(readFile(folder / "a.patina.json"), future);
}

} // namespace patina::tests::document_file_test
