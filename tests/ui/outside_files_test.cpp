// SPDX-License-Identifier: GPL-3.0-or-later
// Files that what is opened names outside its folder.
#include <sys/stat.h>

#include <QTest>

#include "catalog/catalog.h"
#include "docks/dock_context.h"
#include "scene/scene_file.h"
#include "ui/answer.h"
#include "ui/window_fixture.h"

namespace patina::tests::outside_files_test {
namespace {

constexpr int waitMs = 20000;

class OutsideFilesWindow : public WindowFixture {
  protected:
    OutsideFilesWindow() {
        std::filesystem::create_directory(home("scene"));
        writeFile(home("secret.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        writeFile(scene(), R"({"format": "patina.scene", "version": 1, "objects": [
                               {"mesh": "../secret.obj", "preset": {"format": "patina.preset",
                                "version": 1, "model": {"id": "phong", "version": 1}}}]})");
    }

    std::filesystem::path scene() const { return home("scene/a.patina-scene.json"); }
    void openScene() { openFile(scene()); }
    void openFile(const std::filesystem::path& file) {
        window().files().open({QString::fromStdString(file.string())}, Side::A);
    }
    bool isShown() {
        return QTest::qWaitFor(
            [this] {
                return document().scene().objects.size() == 1 &&
                       window().meshes().has(document().scene().objects.front());
            },
            waitMs);
    }
    bool isRefused() {
        window().meshes().view(document().scene().objects.front());
        return QTest::qWaitFor([this] { return said().contains("is not read"); }, waitMs) &&
               !window().meshes().has(document().scene().objects.front());
    }
    QString said() { return QString::fromStdString(text(window().messages().messages())); }
};

TEST_F(OutsideFilesWindow, SceneWithAMeshOutside_IsOpenedWithItWhenThatIsAllowed) {
    const Answer answer(QMessageBox::Yes);
    openScene();
    EXPECT_TRUE(answer.wasAsked());
    EXPECT_TRUE(isShown());
}

TEST_F(OutsideFilesWindow, SceneWithAMeshOutside_IsOpenedWithoutItWhenThatIsRefused) {
    const Answer answer(QMessageBox::No);
    openScene();
    EXPECT_EQ(window().documentFiles().file().path, scene());
    EXPECT_TRUE(isRefused());
    EXPECT_TRUE(said().contains("Allow Files Outside")) << said().toStdString();
}

TEST_F(OutsideFilesWindow, KeyTypedWhileTheQuestionOpens_DoesNotAnswerIt) {
    bool wasOpenAfterKeys = false;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
            timer.stop();
            QTest::keyClick(box, Qt::Key_A); // Allow, had it been a click
            QTest::keyClick(box->defaultButton(), Qt::Key_Return);
            wasOpenAfterKeys = box->isVisible();
            box->button(QMessageBox::No)->click();
        }
    });
    timer.start(0);
    openScene();
    EXPECT_TRUE(wasOpenAfterKeys);
    EXPECT_TRUE(isRefused());
}

TEST_F(OutsideFilesWindow, Answer_IsRememberedAcrossSessions) {
    {
        const Answer answer(QMessageBox::Yes);
        openScene();
    }
    close();
    open();
    const Answer again(QMessageBox::No);
    openScene();
    EXPECT_FALSE(again.wasAsked());
    EXPECT_TRUE(isShown());
}

TEST_F(OutsideFilesWindow, FileThatWantsMore_IsAskedAboutThat) {
    {
        const Answer answer(QMessageBox::Yes);
        openScene();
    }
    std::string text = readFile(scene());
    text.replace(text.find("secret"), 6, "hidden");
    writeFile(scene(), text);
    const Answer again(QMessageBox::No);
    openScene();
    EXPECT_TRUE(again.wasAsked());
}

TEST_F(OutsideFilesWindow, RefusedFiles_CanBeAllowedLater) {
    {
        const Answer answer(QMessageBox::No);
        openScene();
    }
    ASSERT_TRUE(isRefused());
    const Answer answer(QMessageBox::Yes);
    window().files().allowOutside();
    EXPECT_TRUE(answer.wasAsked());
    EXPECT_TRUE(isShown());
    EXPECT_FALSE(document().isModified());
}

/// A pass's image is read like those of materials, but its file is withheld like a mesh.
TEST_F(OutsideFilesWindow, ImageOfAPass_IsReadWhenItIsAllowedLater) {
    QImage marks(4, 4, QImage::Format_RGB32);
    marks.fill(Qt::white);
    marks.setPixel(1, 1, 0);
    ASSERT_TRUE(marks.save(QString::fromStdString(home("marks.png").string())));
    writeFile(scene(), R"({"format": "patina.scene", "version": 1, "objects": [
                           {"mesh": "builtin:sphere", "preset": {"format": "patina.preset",
                            "version": 1, "model": {"id": "phong", "version": 1}}}],
                           "passes": [{"id": "screen", "parameters": {"mark": "image",
                            "threshold": "../marks.png"}}]})");
    const std::string file = home("marks.png").string();
    {
        const Answer answer(QMessageBox::No);
        openScene();
        EXPECT_TRUE(answer.wasAsked());
    }
    const TextureUse image = textureUse({}, file);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return !window().dockContext().textures.problem(image).isEmpty(); }, waitMs));
    EXPECT_TRUE(window().dockContext().textures.preview(file).isNull());
    const Answer answer(QMessageBox::Yes);
    window().files().allowOutside();
    EXPECT_TRUE(answer.wasAsked());
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return !window().dockContext().textures.preview(file).isNull(); }, waitMs));
}

/// A scene whose mesh, of LightWave, has a triangle beside it and one outside.
class LinkedMeshWindow : public OutsideFilesWindow {
  protected:
    LinkedMeshWindow() {
        writeFile(home("scene/own.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        writeFile(home("scene/a.lws"), "LWSC\n3\n\nLoadObjectLayer 1 own.obj\n\n"
                                       "LoadObjectLayer 1 ../secret.obj\n");
        writeFile(scene(), R"({"format": "patina.scene", "version": 1, "objects": [
                               {"mesh": "a.lws", "preset": {"format": "patina.preset",
                                "version": 1, "model": {"id": "phong", "version": 1}}}]})");
    }

    bool hasIndices(std::size_t count) {
        return QTest::qWaitFor(
            [&] {
                const Object& object = document().scene().objects.front();
                return window().meshes().view(object).indices.size() == count;
            },
            waitMs);
    }
    bool isLinkWithheld() {
        return QTest::qWaitFor(
            [this] { return !window().documentFiles().withheld().all().empty(); }, waitMs);
    }
};

TEST_F(LinkedMeshWindow, LinkOutsideTheFolder_IsAskedAboutAndReadWhenAllowed) {
    openScene();
    ASSERT_TRUE(hasIndices(3));
    ASSERT_TRUE(isLinkWithheld());
    EXPECT_TRUE(said().contains("Allow Files Outside")) << said().toStdString();
    const Answer answer(QMessageBox::Yes);
    window().files().allowOutside();
    EXPECT_TRUE(answer.wasAsked());
    EXPECT_TRUE(hasIndices(6));
    EXPECT_TRUE(window().documentFiles().withheld().all().empty());
}

TEST_F(LinkedMeshWindow, AllowedLink_IsReadUnaskedInTheNextSession) {
    openScene();
    ASSERT_TRUE(isLinkWithheld());
    {
        const Answer answer(QMessageBox::Yes);
        window().files().allowOutside();
    }
    close();
    open();
    const Answer again(QMessageBox::No);
    openScene();
    EXPECT_TRUE(hasIndices(6));
    EXPECT_FALSE(again.wasAsked());
}

TEST_F(LinkedMeshWindow, RefusedLink_IsStillKnownWhenTheSceneIsOpenedAgain) {
    openScene();
    ASSERT_TRUE(isLinkWithheld());
    openScene();
    EXPECT_TRUE(isLinkWithheld());
}

TEST_F(OutsideFilesWindow, PresetOfTheScene_IsReadWhenItIsAllowedLater) {
    ASSERT_TRUE(window().documentFiles().savePreset(home("secret.patina.json"), Side::A));
    const std::string name = document().material(Side::A)->name;
    writeFile(scene(), R"({"format": "patina.scene", "version": 1, "objects": [
                           {"mesh": "builtin:cube", "preset": "../secret.patina.json"}]})");
    {
        const Answer answer(QMessageBox::No);
        openScene();
    }
    ASSERT_NE(document().material(Side::A)->name, name);
    const Answer answer(QMessageBox::Yes);
    window().files().allowOutside();
    EXPECT_EQ(document().material(Side::A)->name, name);
}

TEST_F(OutsideFilesWindow, SceneSavedElsewhere_IsOpenedWithItsMeshesUnasked) {
    {
        const Answer answer(QMessageBox::Yes);
        openScene();
    }
    ASSERT_TRUE(isShown());
    std::filesystem::create_directory(home("elsewhere"));
    const std::filesystem::path file = home("elsewhere/b.patina-scene.json");
    ASSERT_TRUE(window().documentFiles().saveScene(file));
    ASSERT_TRUE(window().files().saving().save());
    const Answer again(QMessageBox::No);
    openFile(file);
    EXPECT_FALSE(again.wasAsked());
    EXPECT_TRUE(isShown());
}

TEST_F(OutsideFilesWindow, RecoveredWork_HasWhatWasAllowed) {
    {
        const Answer answer(QMessageBox::Yes);
        openScene();
    }
    std::filesystem::create_directory(home("copies"));
    const std::filesystem::path copy = home("copies/copy.patina-scene.json");
    ASSERT_TRUE(writeScene(copy, window().documentFiles().sceneToRecover()));
    ASSERT_TRUE(window().documentFiles().recover(copy, window().documentFiles().file()));
    EXPECT_TRUE(window().documentFiles().withheld().all().empty());
    EXPECT_TRUE(isShown());
}

TEST_F(OutsideFilesWindow, RecoveredWork_HasNothingThatWasRefused) {
    {
        const Answer answer(QMessageBox::No);
        openScene();
    }
    std::filesystem::create_directory(home("copies"));
    const std::filesystem::path copy = home("copies/copy.patina-scene.json");
    ASSERT_TRUE(writeScene(copy, window().documentFiles().sceneToRecover()));
    ASSERT_TRUE(window().documentFiles().openTemplate(threeLightsFile()));
    ASSERT_TRUE(
        window().documentFiles().recover(copy, {DocumentFile::Kind::Scene, scene(), false}));
    EXPECT_TRUE(isRefused());
}

TEST_F(OutsideFilesWindow, SettingsThatAreAPipe_DoNotHoldUpTheStart) {
    close();
    const std::filesystem::path file = home("XDG_CONFIG_HOME/patina/patina.ini");
    std::filesystem::create_directories(file.parent_path());
    std::filesystem::remove(file);
    ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
    open();
    EXPECT_TRUE(window().isVisible());
}

} // namespace
} // namespace patina::tests::outside_files_test
