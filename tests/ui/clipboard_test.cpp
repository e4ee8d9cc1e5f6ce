// SPDX-License-Identifier: GPL-3.0-or-later
// Materials, objects and lights on the clipboard, start values of models, and originals.
#include <QClipboard>
#include <QGuiApplication>

#include <gtest/gtest.h>

#include "document/random_material.h"
#include "document/scene_edits.h"
#include "document/value_locks.h"
#include "files/clipboard_actions.h"
#include "material/preset_file.h"
#include "resources/mesh_library.h"
#include "session/start_value_files.h"
#include "ui/fixtures.h"

namespace patina::tests::clipboard_test {
namespace {

/// A document that copies and pastes.
struct Desk : FixtureDocument {
    MeshLibrary meshes;
    ClipboardActions actions{document, files, meshes, nullptr};
    Errors told;

    Desk() {
        QObject::connect(&document, &Document::reported, &actions,
                         [this](const Error& error) { told.push_back(error); });
    }
    void set(const std::string& id, const Value& value) { document.setValue(model(), id, value); }
    const std::vector<Object>& objects() const { return document.scene().objects; }
    const std::vector<Light>& lights() const { return document.scene().lights; }
    void addCopies(int count) {
        addObjects(document, std::vector<Object>(std::size_t(count), objects()[0]), "Copies");
    }
};

void setText(const QString& text) {
    QGuiApplication::clipboard()->setText(text);
}

QString clipboardText() {
    return QGuiApplication::clipboard()->text();
}

TEST(Clipboard, Material_GoesToAnotherWindowAsThePresetItIs) {
    Desk from;
    from.set("roughness", 0.75);
    from.actions.copyMaterial();
    EXPECT_TRUE(clipboardText().contains("\"patina.preset\""));
    Desk to;
    to.actions.paste();
    EXPECT_EQ(*to.document.material(Side::A), *from.document.material(Side::A));
    EXPECT_EQ(to.steps(), 1);
    to.document.undoStack().undo();
    EXPECT_EQ(to.number("roughness"), 0.5);
    EXPECT_TRUE(to.told.empty());
}

TEST(Clipboard, Material_GoesOntoAllSelectedObjects) {
    Desk desk;
    desk.addCopies(2);
    desk.document.selection().setObjects({0});
    desk.set("roughness", 0.75);
    desk.actions.copyMaterial();
    desk.document.selection().setObjects({1, 2});
    const int steps = desk.steps();
    desk.actions.paste();
    EXPECT_EQ(desk.objects()[1].material, desk.objects()[0].material);
    EXPECT_EQ(desk.objects()[2].material, desk.objects()[0].material);
    EXPECT_EQ(desk.steps(), steps + 1);
}

TEST(Clipboard, Objects_AreAddedUnderNamesOfTheirOwnAsOneStep) {
    Desk desk;
    desk.addCopies(1);
    desk.document.selection().setObjects({0, 1});
    desk.actions.copyObjects();
    const int steps = desk.steps();
    desk.actions.paste();
    ASSERT_EQ(desk.objects().size(), 4u);
    EXPECT_EQ(desk.objects()[2].name, "Object 3");
    EXPECT_EQ(desk.objects()[3].name, "Object 4");
    EXPECT_EQ(desk.objects()[2].material, desk.objects()[0].material);
    EXPECT_EQ(desk.document.selection().objects(), (std::vector<int>{2, 3}));
    EXPECT_EQ(desk.steps(), steps + 1);
}

TEST(Clipboard, CutObjects_ComeBackWithAPaste) {
    Desk desk;
    desk.addCopies(1);
    const Object cut = desk.objects()[1];
    desk.actions.cutObjects();
    ASSERT_EQ(desk.objects().size(), 1u);
    desk.actions.paste();
    ASSERT_EQ(desk.objects().size(), 2u);
    EXPECT_EQ(desk.objects()[1].name, cut.name);
}

TEST(Clipboard, Light_IsAddedButNoSecondKeyLight) {
    Desk desk;
    Light key = desk.lights()[0];
    key.isKey = true;
    setLight(desk.document, 0, key);
    desk.actions.copyLight();
    desk.actions.paste();
    ASSERT_EQ(desk.lights().size(), 2u);
    EXPECT_EQ(desk.lights()[1].block, key.block);
    EXPECT_FALSE(desk.lights()[1].isKey);
    EXPECT_EQ(desk.document.selection().light(), 1);
    desk.actions.duplicateLight();
    EXPECT_EQ(desk.lights().size(), 3u);
    desk.actions.cutLight();
    EXPECT_EQ(desk.lights().size(), 2u);
}

TEST(Clipboard, TextThatIsNothingOfPatinas_ChangesNothingAndIsToldWithItsPlace) {
    Desk desk;
    setText("hello");
    desk.actions.paste();
    setText("{\n  \"format\": \"other\"\n}");
    desk.actions.paste();
    EXPECT_EQ(desk.steps(), 0);
    ASSERT_GE(desk.told.size(), 2u);
    EXPECT_EQ(desk.told[0].line, 1);
    EXPECT_EQ(desk.told[1].file, "Clipboard");
    EXPECT_EQ(desk.told[1].line, 2);
    EXPECT_EQ(desk.told[1].column, 13);
}

TEST(Clipboard, ImagesOfAPatinaWindow_AreReadAndThoseOfATextAreNot) {
    Desk from;
    from.document.setTexture(from.model(), "diffuse.color",
                             textureUse("diffuse.color", "/somewhere/wood.png"));
    from.actions.copyMaterial();
    Desk to;
    to.actions.paste();
    EXPECT_FALSE(to.document.texture(to.model(), "diffuse.color")->outside);
    setText(clipboardText());
    Desk stranger;
    stranger.actions.paste();
    EXPECT_TRUE(stranger.document.texture(stranger.model(), "diffuse.color")->outside);
}

TEST(Clipboard, ImageThatIsNotReadHere_IsNotReadElsewhere) {
    Desk from;
    TextureUse use = textureUse("diffuse.color", "/somewhere/wood.png");
    use.outside = true;
    from.document.setTexture(from.model(), "diffuse.color", use);
    from.actions.copyMaterial();
    Desk to;
    to.actions.paste();
    EXPECT_TRUE(to.document.texture(to.model(), "diffuse.color")->outside);
}

TEST(Clipboard, MeshThatATextNames_IsWithheld) {
    Desk from;
    Object object = from.objects()[0];
    object.mesh = "/somewhere/bust.obj";
    setObject(from.document, 0, object);
    from.actions.copyObjects();
    setText(clipboardText());
    Desk to;
    to.actions.paste();
    ASSERT_EQ(to.objects().size(), 2u);
    EXPECT_EQ(to.objects()[1].mesh, object.mesh);
    EXPECT_TRUE(to.files.withheld().rights().withheld.contains(object.mesh));
}

TEST(RandomMaterial, PartsInUse_ChangeWithTheModelInOneStep) {
    Desk desk;
    desk.document.setBlock(desk.document.selection().currentPath(kinds::fresnel), "rim");
    setLocked(desk.document, desk.model(), {"roughness"}, true);
    const int steps = desk.steps();
    randomiseMaterial(desk.document, [] { return 1.0; });
    EXPECT_EQ(desk.number("roughness"), 0.5);
    EXPECT_EQ(desk.number("exponent"), 1000.0);
    EXPECT_EQ(desk.document.material(Side::A)->part(kinds::fresnel)->parameters.at("f0"),
              Value(1.0));
    EXPECT_EQ(desk.steps(), steps + 1);
}

TEST(StartValues, ModelChosenAnew_BeginsWithThemWhereNothingCarriesOver) {
    Desk desk;
    desk.document.setStartValues({{"second", {{"gloss", 0.75}, {"diffuse.color", {0, 0, 1}}}}});
    desk.set("diffuse.color", glm::dvec3(0.25));
    desk.document.setModel(Side::A, "second");
    EXPECT_EQ(desk.number("gloss"), 0.75);
    EXPECT_EQ(desk.value("diffuse.color"), Value(glm::dvec3(0.25)));
}

TEST(StartValues, ModelThatWasThereBefore_HasWhatItHadThen) {
    Desk desk;
    desk.document.setModel(Side::A, "second");
    desk.set("gloss", 0.25);
    desk.document.setModel(Side::A, "first");
    desk.document.setStartValues({{"second", {{"gloss", 0.75}}}});
    desk.document.setModel(Side::A, "second");
    EXPECT_EQ(desk.number("gloss"), 0.25);
}

TEST(StartValues, WrittenOnes_AreReadUntilTheyAreRemoved) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeStartValues(folder / "start", "ward", {{"gloss", 0.5}}));
    const StartValueReading reading = readStartValues(folder / "start");
    EXPECT_TRUE(reading.errors.empty());
    EXPECT_EQ(reading.values.at("ward"), (nlohmann::json{{"gloss", 0.5}}));
    ASSERT_TRUE(writeStartValues(folder / "start", "ward", {}));
    EXPECT_TRUE(readStartValues(folder / "start").values.empty());
}

TEST(StartValues, DamagedFile_IsToldAndTheOthersAreRead) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeStartValues(folder.path(), "ward", {{"gloss", 0.5}}));
    writeFile(folder / "broken.json", "{");
    const StartValueReading reading = readStartValues(folder.path());
    EXPECT_EQ(reading.errors.size(), 1u);
    EXPECT_EQ(reading.values.size(), 1u);
}

TEST(Original, EditedMaterial_IsAsItWasOpened) {
    Desk desk;
    const Material opened = *desk.document.material(Side::A);
    desk.set("roughness", 0.75);
    desk.document.setModel(Side::A, "second");
    ASSERT_NE(desk.document.originalMaterial({0, Side::A}), nullptr);
    EXPECT_EQ(*desk.document.originalMaterial({0, Side::A}), opened);
}

TEST(Original, AppliedPreset_IsOneUntilItIsUndone) {
    Desk desk;
    const TemporaryFolder folder;
    Material preset = defaultMaterial(*desk.document.catalog().find(kinds::models, "second"));
    ASSERT_TRUE(writePreset(folder / "a.patina.json", preset, desk.document.catalog()));
    const Material opened = *desk.document.material(Side::A);
    desk.set("roughness", 0.75);
    ASSERT_TRUE(desk.files.applyPreset(folder / "a.patina.json", Side::A));
    const Material applied = *desk.document.material(Side::A);
    desk.set("gloss", 0.75);
    EXPECT_EQ(*desk.document.originalMaterial({0, Side::A}), applied);
    desk.document.undoStack().setIndex(1);
    EXPECT_EQ(*desk.document.originalMaterial({0, Side::A}), opened);
}

TEST(Original, ObjectBehindARemovedOne_KeepsItsOwn) {
    Desk desk;
    desk.addCopies(2);
    desk.document.selection().setObjects({2});
    desk.set("roughness", 0.75);
    const Material second = desk.objects()[1].material;
    removeObjects(desk.document, {0});
    desk.document.selection().setObjects({1});
    EXPECT_EQ(std::get<double>(desk.value("roughness")), 0.75);
    EXPECT_EQ(*desk.document.originalMaterial({1, Side::A}), second);
}

TEST(Original, SideB_IsAsItWasPutThere) {
    Desk desk;
    desk.comparison.setComparing(true);
    const Material second = *desk.document.material(Side::B);
    desk.document.selection().setSide(Side::B);
    desk.set("roughness", 0.75);
    EXPECT_EQ(*desk.document.originalMaterial({0, Side::B}), second);
}

} // namespace
} // namespace patina::tests::clipboard_test
