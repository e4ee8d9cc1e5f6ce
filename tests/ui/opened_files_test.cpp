// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are dropped on the window or named at its start.
#include <QDockWidget>
#include <QDropEvent>
#include <QFileDialog>
#include <QMimeData>
#include <QTest>

#include "catalog/catalog.h"
#include "ui/answer.h"
#include "ui/window_fixture.h"

namespace patina::tests::opened_files_test {
namespace {

constexpr int waitMs = 20000;

class OpenedFiles : public WindowFixture {
  protected:
    /// A scene file that differs from the start in its exposure; the document is new again.
    std::filesystem::path savedScene() {
        const std::filesystem::path file = home("a.patina-scene.json");
        expose(0.5);
        EXPECT_TRUE(window().documentFiles().saveScene(file));
        EXPECT_TRUE(window().documentFiles().openTemplate(threeLightsFile()));
        return file;
    }
    std::filesystem::path sceneFromTheFuture() {
        const std::filesystem::path file = savedScene();
        std::string text = readFile(file);
        const std::string version = "\n  \"version\": 1";
        text.replace(text.rfind(version), version.size(), "\n  \"version\": 99");
        writeFile(file, text);
        return file;
    }
    void expose(double stops) {
        document().setValue(document().selection().currentPath(settings::scene), "exposure", stops);
    }
    void drop(const std::filesystem::path& file, QWidget& target) {
        QMimeData files;
        files.setUrls({QUrl::fromLocalFile(QString::fromStdString(file.string()))});
        QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &files, Qt::LeftButton,
                              Qt::NoModifier);
        QApplication::sendEvent(&target, &enter);
        QDropEvent event(QPointF(50, 50), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&target, &event);
    }
    std::filesystem::path triangle() {
        const std::filesystem::path file = home("triangle.obj");
        writeFile(file, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        return file;
    }
    bool meshArrives() {
        return QTest::qWaitFor([this] { return document().undoStack().count() > 0; }, waitMs);
    }
    QString said() { return QString::fromStdString(text(window().messages().messages())); }
};

TEST_F(OpenedFiles, SceneDroppedOnAView_Opens) {
    const std::filesystem::path file = savedScene();
    drop(file, view());
    EXPECT_EQ(document().scene().exposure, 0.5);
    EXPECT_EQ(window().documentFiles().file().path, file);
    EXPECT_TRUE(window().windowTitle().contains("a.patina-scene.json"));
}

TEST_F(OpenedFiles, SceneDroppedOnTheWindow_Opens) {
    const std::filesystem::path file = savedScene();
    drop(file, window());
    EXPECT_EQ(document().scene().exposure, 0.5);
}

TEST_F(OpenedFiles, SceneDroppedOnUnsavedWork_Asks) {
    const std::filesystem::path file = savedScene();
    expose(1.0);
    const Answer answer(QMessageBox::Cancel);
    drop(file, view());
    EXPECT_TRUE(answer.wasAsked());
    EXPECT_EQ(document().scene().exposure, 1.0);
}

TEST_F(OpenedFiles, DamagedSceneThatIsDropped_IsAMessage) {
    const std::filesystem::path file = home("bad.patina-scene.json");
    writeFile(file, "{\"format\": ");
    const Scene before = document().scene();
    drop(file, view());
    EXPECT_TRUE(said().contains("bad.patina-scene.json:1:"));
    EXPECT_EQ(document().scene(), before);
}

TEST_F(OpenedFiles, SceneFromTheFuture_OpensReadOnlyAndSaysSo) {
    drop(sceneFromTheFuture(), view());
    EXPECT_EQ(document().scene().exposure, 0.5);
    EXPECT_TRUE(window().windowTitle().contains("read-only"));
    EXPECT_TRUE(said().contains("newer Patina")) << said().toStdString();
}

TEST_F(OpenedFiles, SceneFromTheFuture_IsSavedToAnotherFileOnly) {
    const std::filesystem::path file = sceneFromTheFuture();
    const std::string before = readFile(file);
    drop(file, view());
    expose(1.0);
    bool asked = false;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&asked] {
        if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
            asked = true;
            dialog->reject();
        }
    });
    timer.start(20);
    EXPECT_FALSE(window().files().saving().save());
    EXPECT_TRUE(asked);
    EXPECT_EQ(readFile(file), before);
}

TEST_F(OpenedFiles, DroppedMesh_IsOneStepWithTheCamera) {
    const Camera before = camera();
    drop(triangle(), view());
    ASSERT_TRUE(meshArrives());
    const Camera framed = camera();
    EXPECT_FALSE(framed == before);
    EXPECT_EQ(document().undoStack().count(), 1);
    document().undoStack().undo();
    EXPECT_EQ(camera(), before);
    document().undoStack().redo();
    EXPECT_EQ(camera(), framed);
}

TEST_F(OpenedFiles, DamagedFileAtTheFirstStart_ShowsItsMessage) {
    close();
    const std::filesystem::path file = home("bad.patina.json");
    writeFile(file, "{}");
    Theme theme;
    MainWindow first(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots())), theme);
    first.documentFiles().openTemplate(threeLightsFile());
    first.files().open({QString::fromStdString(file.string())}, Side::A);
    first.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&first, waitMs));
    EXPECT_TRUE(first.dock("messages")->isVisible());
}

TEST_F(OpenedFiles, FirstStartWithNothingToSay_HidesTheMessages) {
    EXPECT_FALSE(window().dock("messages")->isVisible());
}

} // namespace
} // namespace patina::tests::opened_files_test
