// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <QDockWidget>
#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPointer>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include "docks/picture_grid.h"
#include "docks/preset_view.h"
#include "document/scene_edits.h"
#include "files/key_pause.h"
#include "parameters/row_mark.h"
#include "ui/answer.h"
#include "ui/window_fixture.h"

namespace patina::tests::window_test {
namespace {

class Window : public WindowFixture {
  protected:
    using WindowFixture::WindowFixture;

    /// Drops a mesh of one triangle onto the first view.
    void drop(const std::string& name) {
        writeFile(home(name), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        window().files().drop({QString::fromStdString(home(name).string())}, Side::A);
    }
};

class Layout : public Window {
  protected:
    Layout() : Window(Size::AsAtFirstStart) {}
};

constexpr int waitMs = 20000;

void edit(Document& document) {
    document.setValue(document.selection().currentPath(settings::scene), "exposure", 0.5);
}

bool waitUntil(const std::function<bool()>& holds) {
    return QTest::qWaitFor(holds, waitMs);
}

int copiesIn(const std::filesystem::path& folder) {
    int copies = 0;
    std::error_code missing; // then there are none
    for (const auto& file : std::filesystem::directory_iterator(folder, missing)) {
        copies += file.path().extension() == ".json" ? 1 : 0;
    }
    return copies;
}

std::string journalIn(const std::filesystem::path& folder) {
    std::error_code missing; // then there is none
    for (const auto& file : std::filesystem::directory_iterator(folder, missing)) {
        if (file.path().extension() == ".journal") {
            return readFile(file.path());
        }
    }
    return {};
}

QString messagesIn(MainWindow& window) {
    return QString::fromStdString(text(window.messages().messages()));
}

TEST_F(Window, Start_IsUnmodified) {
    EXPECT_FALSE(window().isWindowModified());
}

TEST_F(Layout, DocksOpenAtTheEnd_AreOpenAtTheNextStart) {
    window().findChild<QDockWidget*>("effects")->show();
    window().findChild<QDockWidget*>("presets")->hide();
    window().close();
    close();
    open();
    EXPECT_TRUE(window().findChild<QDockWidget*>("effects")->isVisible());
    EXPECT_FALSE(window().findChild<QDockWidget*>("presets")->isVisible());
    EXPECT_FALSE(window().findChild<QDockWidget*>("stability")->isVisible());
}

TEST_F(Layout, AccuracyDock_OpensHighEnoughToRead) {
    const int room = window().centralWidget()->height();
    QDockWidget& dock = *window().dock("accuracy");
    dock.show();
    EXPECT_TRUE(QTest::qWaitFor([&] { return dock.height() > std::min(350, room * 2 / 5); }))
        << dock.height() << " of " << room;
    EXPECT_LT(dock.height(), room / 2);
}

TEST_F(Layout, HeightOfADock_IsKeptForTheNextStart) {
    constexpr int chosen = 290;
    constexpr int lowest = 300; ///< at which it opens
    window().dock("accuracy")->show();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window().dock("accuracy")->height() > lowest; }));
    window().resizeDocks({window().dock("accuracy")}, {chosen}, Qt::Vertical);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window().dock("accuracy")->height() == chosen; }));
    window().dock("accuracy")->hide();
    window().close();
    close();
    open();
    window().dock("accuracy")->show();
    QTest::qWait(1000); // as long as it would take to grow
    EXPECT_NEAR(window().dock("accuracy")->height(), chosen, 2);
}

TEST_F(Layout, FirstWindow_LeavesRoomForItsFrameOnTheScreen) {
    const QSize screen = window().screen()->availableSize();
    EXPECT_LT(window().normalGeometry().height(), screen.height() - 30); // a title bar
    EXPECT_LT(window().normalGeometry().width(), screen.width());
    EXPECT_TRUE(window().isMaximized()); // a screen of 1600 x 1000 has no room around it
}

TEST_F(Layout, NarrowestParameters_ShowTheirResetMarks) {
    window().resizeDocks({window().dock("parameters")}, {100}, Qt::Horizontal);
    QTest::qWait(200); // layouts that were put off
    const QDockWidget& dock = *window().dock("parameters");
    int marks = 0;
    for (const RowMark* mark : dock.findChildren<RowMark*>("reset")) {
        if (mark->isVisible()) {
            ++marks;
            EXPECT_LE(mark->mapTo(&dock, mark->rect().bottomRight()).x(), dock.width());
        }
    }
    EXPECT_GT(marks, 0);
    EXPECT_LT(dock.width(), 400);
}

TEST_F(Window, NoteOnAMesh_IsCountedAndOpensNoDock) {
    auto* badge = window().findChild<QToolButton*>("messageBadge");
    Q_EMIT window().meshes().remarked({"a.obj", 0, 0, "96 of 2304 triangles had no area", {}});
    EXPECT_FALSE(window().dock("messages")->isVisible());
    EXPECT_EQ(badge->text(), "1 note");
    EXPECT_TRUE(messagesIn(window()).contains("had no area"));
    window().messages().add({"b.obj", 0, 0, "the file cannot be read", {}});
    EXPECT_TRUE(window().dock("messages")->isVisible());
    EXPECT_EQ(badge->text(), "⚠ 2 messages");
}

TEST_F(Window, AddButtonOfTheLights_StaysWhereItIsAsTheyBecomeMore) {
    QWidget& lights = *window().dock("lights");
    const auto place = [&lights] {
        QTest::qWait(50); // a layout that was put off
        for (QToolButton* button : lights.findChildren<QToolButton*>()) {
            if (button->text() == "Add") {
                return button->mapTo(&lights, QPoint());
            }
        }
        return QPoint();
    };
    while (!document().scene().lights.empty()) {
        removeLight(document(), 0);
    }
    const QPoint before = place();
    const std::string kind = document().catalog().ofKind(kinds::lights).front()->id;
    for (int i = 0; i < 8; ++i) {
        addLight(document(), kind);
    }
    EXPECT_EQ(place(), before);
    EXPECT_FALSE(before.isNull());
}

TEST_F(Window, Edit_MarksTheTitle) {
    edit(document());
    EXPECT_TRUE(window().isWindowModified());
}

TEST_F(Window, CloseWithoutEdits_AsksNothing) {
    EXPECT_TRUE(window().QWidget::close());
}

TEST_F(Window, CloseWithUnsavedWork_Asks) {
    edit(document());
    const Answer answer(QMessageBox::Cancel);
    EXPECT_FALSE(window().QWidget::close());
    EXPECT_TRUE(answer.wasAsked());
}

TEST_F(Window, CloseAnsweredWithDiscard_Closes) {
    edit(document());
    const Answer answer(QMessageBox::Discard);
    EXPECT_TRUE(window().QWidget::close());
}

TEST_F(Window, SaveIntoAFolderThatIsNotThere_SaysSoAndStaysModified) {
    edit(document());
    EXPECT_FALSE(window().documentFiles().saveScene(home("missing") / "a.patina-scene.json"));
    EXPECT_TRUE(document().isModified());
    EXPECT_TRUE(messagesIn(window()).contains("a.patina-scene.json"));
}

TEST_F(Window, FailedImport_SaysSoAndKeepsTheScene) {
    const Scene before = document().scene();
    writeFile(home("broken.obj"), "f 1 2 3\n");
    window().files().open({QString::fromStdString(home("broken.obj").string())}, Side::A);
    EXPECT_TRUE(waitUntil([&] { return messagesIn(window()).contains("broken.obj"); }));
    EXPECT_EQ(document().scene(), before);
}

TEST_F(Window, MeshDroppedOnANewDocument_ReplacesItsObject) {
    const Object start = document().scene().objects[0];
    drop("triangle.obj");
    ASSERT_TRUE(waitUntil([&] { return document().isModified(); }));
    ASSERT_EQ(document().scene().objects.size(), 1u);
    EXPECT_EQ(document().scene().objects[0].name, "triangle");
    EXPECT_EQ(document().scene().objects[0].material, start.material);
    document().undoStack().undo();
    EXPECT_EQ(document().scene().objects[0], start);
}

TEST_F(Window, MeshDroppedOnAnEditedDocument_StandsBesideTheOthers) {
    edit(document());
    drop("triangle.obj");
    ASSERT_TRUE(waitUntil([&] { return document().scene().objects.size() == 2; }));
    EXPECT_EQ(document().selection().object(), 1);
    const glm::dvec3& place = document().scene().objects[1].translation;
    EXPECT_GT(place.x, 1.0);
    for (const double steps : {1e5 * place.x, 1e5 * place.y, 1e5 * place.z}) {
        EXPECT_NEAR(steps, std::round(steps), 1e-6); // no noise of single precision in the form
        EXPECT_FALSE(steps == 0.0 && std::signbit(steps));
    }
}

TEST_F(Window, DroppedMesh_IsFramed) {
    edit(document());
    drop("triangle.obj");
    ASSERT_TRUE(waitUntil([&] { return document().scene().objects.size() == 2; }));
    EXPECT_NEAR(camera().pivot.x, document().scene().objects[1].translation.x, 0.5);
}

TEST_F(Window, ObjectInAnEmptyScene_LooksLikeANewDocuments) {
    const Material start = document().scene().objects[0].material;
    removeObjects(document(), {0});
    ASSERT_TRUE(document().scene().objects.empty());
    Object sphere;
    sphere.mesh = "builtin:sphere";
    window().files().meshes().addObject(sphere);
    EXPECT_EQ(document().scene().objects[0].material, start);
    EXPECT_EQ(document().selection().object(), 0);
}

TEST_F(Window, ExportedPicture_IsWhatTheViewShows) {
    QSignalSpy saved(&window().pictures(), &PictureExport::saved);
    const QString file = QString::fromStdString(home("a.png").string());
    window().pictures().save(file, pictureOf(view()));
    ASSERT_TRUE(saved.wait(waitMs)) << messagesIn(window()).toStdString();
    const QImage shown = view().grabPicture().convertToFormat(QImage::Format_RGB888);
    const QImage written = QImage(file).convertToFormat(QImage::Format_RGB888);
    ASSERT_EQ(written.size(), shown.size());
    int largest = 0;
    for (int y = 0; y < shown.height(); ++y) {
        for (int i = 0; i < 3 * shown.width(); ++i) {
            const int wanted = shown.constScanLine(y)[i];
            largest = std::max(largest, std::abs(written.constScanLine(y)[i] - wanted));
        }
    }
    EXPECT_EQ(largest, 0);
}

TEST_F(Window, PictureThatCannotBeWritten_IsAMessage) {
    const QString file = QString::fromStdString((home("missing") / "a.png").string());
    window().pictures().save(file, pictureOf(view()));
    EXPECT_TRUE(waitUntil([&] { return window().messages().count() > 0; }));
}

TEST_F(Window, ShippedPresets_AppearInTheirDock) {
    window().startRest();
    auto* view = window().dock("presets")->findChild<PresetView*>();
    ASSERT_NE(view, nullptr);
    EXPECT_TRUE(waitUntil([&] { return view->model()->rowCount() > 0; }));
}

TEST_F(Window, PresetsThatWereNotReadYet_AreNotSaidToBeMissing) {
    const auto says = [this](const QString& text) {
        const auto labels = window().dock("presets")->findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](const QLabel* label) {
            return !label->isHidden() && label->text() == text;
        });
    };
    EXPECT_TRUE(says("The presets are being read…"));
    window().startRest();
    EXPECT_TRUE(waitUntil([&] { return !says("The presets are being read…"); }));
    EXPECT_FALSE(says("There are no presets yet."));
}

TEST_F(Window, ModelInTheUsersFolder_AppearsInTheChooser) {
    window().startRest();
    auto* grid = window().dock("models")->findChild<PictureGrid*>();
    const std::filesystem::path folder = home("XDG_DATA_HOME") / "patina/shaders/models";
    std::filesystem::create_directories(folder);
    writeFile(folder / "homemade.glsl",
              "// SPDX-License-"
              "Identifier: MIT-0\n#include \"lib/directions.glsl\"\n"
              "vec3 homemade(Directions d, Homemade p) {\n    return p.tint * d.nl;\n}\n");
    writeFile(folder / "homemade.json", R"({
        "id": "homemade", "version": 1, "label": "Homemade", "summary": "For tests.",
        "applications": "Tests.", "source": "None", "doc": "For tests.",
        "parameters": [{"id": "tint", "label": "Tint", "type": "color", "default": [1, 0, 0],
                        "min": 0, "max": 1, "doc": "Its colour."}],
        "claims": ["finite"]})");
    EXPECT_TRUE(waitUntil([&] { return grid->find("homemade") != nullptr; }));
}

TEST_F(Window, ShaderThatStopsCompiling_KeepsThePictureAndNamesTheLine) {
    const std::filesystem::path folder = home("XDG_DATA_HOME") / "patina/shaders/models";
    std::filesystem::create_directories(folder);
    const std::string good = "// SPDX-License-"
                             "Identifier: MIT-0\n#include \"lib/directions.glsl\"\n"
                             "vec3 homemade(Directions d, Homemade p) {\n"
                             "    return p.tint * d.nl;\n}\n";
    writeFile(folder / "homemade.glsl", good);
    writeFile(folder / "homemade.json", R"({
        "id": "homemade", "version": 1, "label": "Homemade", "summary": "For tests.",
        "applications": "Tests.", "source": "None", "doc": "For tests.",
        "parameters": [{"id": "tint", "label": "Tint", "type": "color", "default": [1, 0, 0],
                        "min": 0, "max": 1, "doc": "Its colour."}],
        "claims": ["finite"]})");
    close();
    open();
    window().startRest();
    document().setModel(Side::A, "homemade");
    window().dock("messages")->show(); // or its coming would make the view smaller
    newFrames();
    const QImage before = view().grabPicture();
    std::string broken = good;
    broken.replace(broken.find("d.nl"), 4, "d.no");
    writeFile(folder / "homemade.glsl", broken);
    EXPECT_TRUE(waitUntil([&] { return messagesIn(window()).contains("homemade.glsl:4"); }))
        << messagesIn(window()).toStdString();
    EXPECT_EQ(view().grabPicture(), before);
}

TEST_F(Window, ProgramKilledWithUnsavedWork_OffersItAtTheNextStart) {
    const std::filesystem::path folder = home("XDG_STATE_HOME") / "patina/autosave";
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATINA_TIME_STARTUP", "1");
    program.setProcessEnvironment(environment);
    window().hide();
    program.start(PATINA_BINARY_DIR "/bin/patina", QStringList());
    ASSERT_TRUE(program.waitForStarted(waitMs));
    QByteArray said;
    ASSERT_TRUE(waitUntil([&] {
        said += program.readAllStandardError();
        return said.contains("first frame");
    })) << said.toStdString();
    QTest::qWait(500); // the docks it shows first
    ASSERT_EQ(QProcess::execute("xdotool",
                                {"mousemove", "750", "450", "keydown", "ctrl", "mousedown", "1",
                                 "mousemove", "800", "470", "mouseup", "1", "keyup", "ctrl"}),
              0);
    const auto isSaved = [&] {
        return std::filesystem::exists(folder) &&
               std::any_of(std::filesystem::directory_iterator(folder), {}, [](const auto& file) {
                   return file.path().string().ends_with(".patina-scene.json");
               });
    };
    EXPECT_TRUE(waitUntil(isSaved));
    program.kill();
    program.waitForFinished(waitMs);
    window().show();
    window().offerRecovery();
    auto* question = window().findChild<QMessageBox*>("recovery");
    ASSERT_NE(question, nullptr);
    const glm::dvec3 before = document().scene().objects[0].rotation;
    question->defaultButton()->click();
    EXPECT_NE(document().scene().objects[0].rotation, before);
    EXPECT_TRUE(document().isModified());
}

TEST_F(Window, RecoveredWork_KnowsItsFileAndIsModified) {
    window().autosave().setIntervals(1, 1);
    ASSERT_TRUE(window().documentFiles().saveScene(home("a.patina-scene.json")));
    edit(document());
    const std::filesystem::path folder = home("XDG_STATE_HOME") / "patina/autosave";
    ASSERT_TRUE(waitUntil([&] { return copiesIn(folder) == 1; }));
    close();
    open();
    window().offerRecovery();
    auto* question = window().findChild<QMessageBox*>("recovery");
    ASSERT_NE(question, nullptr);
    question->defaultButton()->click();
    EXPECT_EQ(window().documentFiles().file().path, home("a.patina-scene.json"));
    EXPECT_TRUE(window().isWindowModified());
    EXPECT_EQ(document().scene().exposure, 0.5);
}

TEST_F(Window, EveryEdit_IsRecoveredWithoutAnotherOne) {
    const std::filesystem::path folder = home("XDG_STATE_HOME") / "patina/autosave";
    edit(document());
    ASSERT_TRUE(waitUntil([&] { return copiesIn(folder) == 1 && !journalIn(folder).empty(); }));
    document().setValue(document().selection().currentPath(settings::scene), "exposure", -0.5);
    ASSERT_TRUE(waitUntil([&] { return journalIn(folder).find("-0.5") != std::string::npos; }));
    close();
    open();
    window().offerRecovery();
    window().findChild<QMessageBox*>("recovery")->defaultButton()->click();
    EXPECT_EQ(document().scene().exposure, -0.5);
}

TEST_F(Window, EditsThatAreUndone_LeaveNoUnsavedWork) {
    const std::filesystem::path folder = home("XDG_STATE_HOME") / "patina/autosave";
    edit(document());
    ASSERT_TRUE(waitUntil([&] { return copiesIn(folder) == 1; }));
    document().undoStack().undo();
    EXPECT_TRUE(waitUntil([&] { return copiesIn(folder) == 0; }));
    document().undoStack().redo();
    EXPECT_TRUE(waitUntil([&] { return copiesIn(folder) == 1; }));
}

TEST_F(Window, KeyTypedWhileTheQuestionOpens_DoesNotAnswerIt) {
    window().autosave().setIntervals(1, 1);
    edit(document());
    const std::filesystem::path folder = home("XDG_STATE_HOME") / "patina/autosave";
    ASSERT_TRUE(waitUntil([&] { return copiesIn(folder) == 1; }));
    close();
    open();
    window().offerRecovery();
    QPointer<QMessageBox> question = window().findChild<QMessageBox*>("recovery");
    QTest::keyClick(question->defaultButton(), Qt::Key_Return);
    QTest::keyClick(question.data(), Qt::Key_Escape);
    ASSERT_TRUE(question != nullptr && question->isVisible());
    EXPECT_EQ(document().scene().exposure, 0.0);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(question.data(), waitMs));
    QTest::qWait(2 * KeyPause::pauseMs);
    QTest::keyClick(question->defaultButton(), Qt::Key_Return);
    EXPECT_EQ(document().scene().exposure, 0.5);
}

TEST_F(Window, RecoveredWorkThatIsNotSaved_IsOfferedAgain) {
    window().autosave().setIntervals(1, 1);
    edit(document());
    const std::filesystem::path folder = home("XDG_STATE_HOME") / "patina/autosave";
    ASSERT_TRUE(waitUntil([&] { return copiesIn(folder) == 1; }));
    close();
    open();
    window().offerRecovery();
    auto* question = window().findChild<QMessageBox*>("recovery");
    ASSERT_NE(question, nullptr);
    question->defaultButton()->click();
    const Answer answer(QMessageBox::Discard);
    EXPECT_TRUE(window().QWidget::close());
    EXPECT_EQ(Autosave::found(folder).size(), 1u);
}

TEST_F(Window, SaveOfAPresetWithMoreThanItsMaterial_OffersAScene) {
    ASSERT_TRUE(window().documentFiles().openPreset(otherPreset(document())));
    edit(document());
    QString offered;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&offered] {
        if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
            offered = dialog->selectedNameFilter();
            dialog->reject();
        }
    });
    timer.start(20);
    EXPECT_FALSE(window().files().saving().save());
    EXPECT_TRUE(offered.contains("*.patina-scene.json")) << offered.toStdString();
}

TEST_F(Window, AddedBuiltinMesh_StandsBesideTheOthers) {
    Object cube;
    cube.mesh = "builtin:cube";
    window().files().meshes().addBeside(cube);
    ASSERT_EQ(document().scene().objects.size(), 2u);
    EXPECT_GT(document().scene().objects[1].translation.x, 1.0);
}

TEST_F(Window, Save_WritesAMovedCamera) {
    ASSERT_TRUE(window().documentFiles().saveScene(home("a.patina-scene.json")));
    const std::string before = readFile(home("a.patina-scene.json"));
    drag(Qt::LeftButton, Qt::NoModifier, {60, 20});
    ASSERT_TRUE(window().files().saving().save());
    EXPECT_NE(readFile(home("a.patina-scene.json")), before);
}

TEST_F(Window, CloseAfterAnOrbit_AsksNothing) {
    ASSERT_TRUE(window().documentFiles().saveScene(home("a.patina-scene.json")));
    drag(Qt::LeftButton, Qt::NoModifier, {60, 20});
    EXPECT_FALSE(window().isWindowModified());
    EXPECT_TRUE(window().QWidget::close());
}

TEST_F(Window, SaveOfAFileThatIsGone_WritesItAgain) {
    ASSERT_TRUE(window().documentFiles().saveScene(home("a.patina-scene.json")));
    const std::string saved = readFile(home("a.patina-scene.json"));
    std::filesystem::remove(home("a.patina-scene.json"));
    ASSERT_TRUE(window().files().saving().save());
    EXPECT_EQ(readFile(home("a.patina-scene.json")), saved);
}

TEST_F(Window, RunningProgramsWork_IsNotOffered) {
    window().autosave().setIntervals(1, 1);
    edit(document());
    const std::filesystem::path folder = home("XDG_STATE_HOME") / "patina/autosave";
    ASSERT_TRUE(waitUntil([&] { return copiesIn(folder) == 1; }));
    EXPECT_TRUE(Autosave::found(folder).empty());
}

TEST_F(Window, SavedWork_LeavesNoCopy) {
    window().autosave().setIntervals(1, 1);
    ASSERT_TRUE(window().documentFiles().saveScene(home("a.patina-scene.json")));
    edit(document());
    const std::filesystem::path folder = home("XDG_STATE_HOME") / "patina/autosave";
    ASSERT_TRUE(waitUntil([&] { return copiesIn(folder) == 1; }));
    ASSERT_TRUE(window().files().saving().save());
    EXPECT_EQ(copiesIn(folder), 0);
}

} // namespace
} // namespace patina::tests::window_test
