// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line, the menu and a drop name is opened, or it is said why not.
#include <chrono>

#include <QSignalSpy>
#include <QTest>

#include "catalog/catalog.h"
#include "core/table_number.h"
#include "resources/texture_library.h"
#include "support/measured_files.h"
#include "ui/answer.h"
#include "ui/window_fixture.h"

namespace patina::tests::open_files_test {
namespace {

constexpr int readingMs = 20000;

class OpenFiles : public WindowFixture {
  protected:
    /// The scene as it stands, under another name.
    QString sceneFile(const std::string& name) {
        EXPECT_TRUE(window().documentFiles().saveScene(home("a.patina-scene.json")));
        std::filesystem::rename(home("a.patina-scene.json"), home(name));
        EXPECT_TRUE(window().documentFiles().openTemplate(threeLightsFile()));
        return QString::fromStdString(home(name).string());
    }

    QString presetFile() { return QString::fromStdString(otherPreset(document()).string()); }

    std::string messages() { return text(window().messages().messages()); }

    /// Waits until a message has the word.
    bool tells(const char* word) {
        return QTest::qWaitFor([&] { return messages().find(word) != std::string::npos; },
                               readingMs);
    }
};

TEST_F(OpenFiles, SceneWithAPlainName_IsOpenedByItsFormat) {
    const QString file = sceneFile("plain.json");
    window().files().open({file}, Side::A);
    EXPECT_EQ(window().documentFiles().file().kind, DocumentFile::Kind::Scene);
    EXPECT_EQ(messages(), "");
}

TEST_F(OpenFiles, TwoPresets_AreTheTwoSides) {
    window().files().open({presetFile(), presetFile()}, Side::A);
    EXPECT_TRUE(document().isComparing());
    EXPECT_EQ(messages(), "");
}

TEST_F(OpenFiles, MeasuredFile_IsAMaterialThatIsReadOnly) {
    writeFile(home("paint.binary"), merlBytes({4, 4, 4}, [](const DirectionPair&) {
                  return glm::dvec3(0.5, 0.25, 0.125) / 3.14159265358979;
              }));
    const QString file = QString::fromStdString(home("paint.binary").string());
    window().files().open({file}, Side::A);
    EXPECT_FALSE(window().documentFiles().file().readOnly); // it is read beside the window
    ASSERT_TRUE(
        QTest::qWaitFor([this] { return window().documentFiles().file().readOnly; }, readingMs));
    EXPECT_EQ(messages(), "");
    EXPECT_EQ(document().material(Side::A)->name, "paint");
    const int before = document().undoStack().count();
    window().files().drop({file}, Side::A);
    settle();
    EXPECT_LE(document().undoStack().count(), before + 1);
    writeFile(home("paint.binary"), "no numbers at all, but text of some length");
    window().files().drop({file}, Side::A);
    EXPECT_TRUE(tells("paint.binary"));
    EXPECT_EQ(document().material(Side::A)->name, "paint");
    const std::filesystem::path other = home("other.binary");
    writeFile(other, "no numbers at all, but text of some length");
    document().setValue(pathOf(kinds::models), "file", other.string());
    EXPECT_TRUE(tells("other.binary"));
}

TEST(OpenedTables, OfAMeasuredFile_AreGreyUntilTheyAreRead) {
    const TemporaryFolder folder;
    writeFile(folder / "paint.binary",
              merlBytes({2, 2, 2}, [](const DirectionPair&) { return glm::dvec3(0.1); }));
    const int number = tableNumber((folder / "paint.binary").string(), TableForm::WithoutGrain);
    AssetClient client;
    TextureLibrary textures([&client]() -> AssetClient& { return client; });
    const QSignalSpy arrived(&textures, &TextureLibrary::arrived);
    EXPECT_EQ(textures.table(number), textures.table(0));
    EXPECT_EQ(textures.table(number), textures.table(0)); // and is read once
    ASSERT_TRUE(QTest::qWaitFor([&] { return arrived.count() > 0; }, readingMs));
    EXPECT_NE(textures.table(number), textures.table(0));
    EXPECT_EQ(textures.table(number)->bins, glm::ivec3(2));
    EXPECT_EQ(arrived.count(), 1);
}

TEST_F(OpenFiles, SceneBesideAPreset_IsNamedAsNotOpened) {
    const QString scene = sceneFile("b.patina-scene.json");
    window().files().open({presetFile(), scene}, Side::A);
    EXPECT_EQ(window().documentFiles().file().kind, DocumentFile::Kind::Preset);
    EXPECT_NE(messages().find("b.patina-scene.json"), std::string::npos) << messages();
}

TEST_F(OpenFiles, ThirdPreset_IsNamedAsNotOpened) {
    window().files().open({presetFile(), presetFile(), "third.patina.json"}, Side::A);
    EXPECT_NE(messages().find("third.patina.json"), std::string::npos) << messages();
}

TEST_F(OpenFiles, RelativePath_StaysTheSameFileElsewhere) {
    sceneFile("here.patina-scene.json");
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(home("."));
    window().files().open({"here.patina-scene.json"}, Side::A);
    std::filesystem::current_path(before);
    EXPECT_EQ(window().documentFiles().file().path, home("here.patina-scene.json"));
}

TEST_F(OpenFiles, MeshOnItsWayWhenAnotherDocumentCame_IsNotAddedToIt) {
    writeFile(home("late.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    window().files().open({QString::fromStdString(home("late.obj").string())}, Side::A);
    window().files().newDocument();
    EXPECT_TRUE(QTest::qWaitFor([this] { return !window().meshes().isLoading(); }, readingMs));
    newFrames();
    EXPECT_EQ(document().scene().objects.size(), 1u);
    EXPECT_FALSE(document().isModified());
}

TEST_F(OpenFiles, FileChangedByAnotherProgram_IsAskedAboutBeforeItIsReplaced) {
    const QString scene = sceneFile("ours.patina-scene.json");
    window().files().open({scene}, Side::A);
    writeFile(home("ours.patina-scene.json"), "theirs");
    std::filesystem::last_write_time(home("ours.patina-scene.json"),
                                     std::filesystem::file_time_type::clock::now() +
                                         std::chrono::seconds(5));
    const Answer no(QMessageBox::No);
    EXPECT_FALSE(window().files().saving().save());
    EXPECT_TRUE(no.wasAsked());
    EXPECT_EQ(readFile(home("ours.patina-scene.json")), "theirs");
}

TEST_F(OpenFiles, FileThatOnlyWeWrote_IsReplacedWithoutAQuestion) {
    const QString scene = sceneFile("ours.patina-scene.json");
    window().files().open({scene}, Side::A);
    const Answer no(QMessageBox::No);
    EXPECT_TRUE(window().files().saving().save());
    EXPECT_TRUE(window().files().saving().save());
    EXPECT_FALSE(no.wasAsked());
}

} // namespace
} // namespace patina::tests::open_files_test
