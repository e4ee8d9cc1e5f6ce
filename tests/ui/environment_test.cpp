// SPDX-License-Identifier: GPL-3.0-or-later
// The environment in the window: chosen, dropped, undone, and drawn until it has settled.
#include <QDockWidget>
#include <QLabel>
#include <QMimeData>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTest>

#include "docks/block_chooser.h"
#include "docks/environment_chooser.h"
#include "docks/lamp_taking.h"
#include "document/compare_edits.h"
#include "document/scene_edits.h"
#include "scene/environment.h"
#include "session/session.h"
#include "ui/window_fixture.h"

namespace patina::tests::environment_test {
namespace {

constexpr int limitMs = 120000;

class EnvironmentInTheWindow : public WindowFixture {
  protected:
    bool waitForSamples(int samples) {
        return QTest::qWaitFor([=, this] { return view().frames().samples() >= samples; }, limitMs);
    }

    /// The mean of what is on the screen, 0 to 255.
    double brightness() {
        const QImage shown = view().grabPicture();
        double sum = 0.0;
        for (int y = 0; y < shown.height(); ++y) {
            for (int x = 0; x < shown.width(); ++x) {
                sum += qGray(shown.pixel(x, y));
            }
        }
        return sum / shown.width() / shown.height();
    }

    /// A panorama of one colour in a format without compression: Radiance, 8 by 4.
    std::string panorama(const char* name = "sky.hdr") {
        const std::string file = home(name).string();
        std::string text = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n";
        for (int i = 0; i < 32; ++i) {
            text += std::string("\x80\x80\x80\x81", 4); // 1 in each channel
        }
        writeFile(file, text);
        return file;
    }
};

TEST_F(EnvironmentInTheWindow, LeftAlone_SettlesAndThenDrawsNothing) {
    constexpr int wanted = 64;
    view().setFixedSize(160, 120);
    document().setBlock(pathOf(kinds::environment), "studio");
    document().setValue(document().selection().currentPath(kinds::environment), "directions",
                        wanted);
    ASSERT_TRUE(waitForSamples(wanted));
    newFrames();
    QTest::qWait(1000);
    EXPECT_EQ(newFrames(), 0);
    EXPECT_EQ(view().frames().samples(), wanted);
}

TEST_F(EnvironmentInTheWindow, ChangedValue_StartsAgainWithoutAProgram) {
    view().setFixedSize(160, 120);
    document().setBlock(pathOf(kinds::environment), "studio");
    ASSERT_TRUE(waitForSamples(24));
    QSignalSpy frames(&view().frames(), &FrameLoop::frameDrawn);
    document().setValue(document().selection().currentPath(kinds::environment), "key.intensity",
                        2.0);
    ASSERT_TRUE(frames.wait());
    EXPECT_LT(view().frames().samples(), 24);
    EXPECT_EQ(view().frames().report().compiled, 0);
}

/// Samples take the fitted picture's place little by little, and it never blinks.
TEST_F(EnvironmentInTheWindow, WhileItChanges_IsFittedAndSettlesWithoutAJump) {
    constexpr int wanted = 64;
    view().setFixedSize(160, 120);
    document().setBlock(pathOf(kinds::environment), "studio");
    const BlockPath path = document().selection().currentPath(kinds::environment);
    document().setValue(path, "directions", wanted);
    ASSERT_TRUE(waitForSamples(wanted));
    newFrames();
    int compiled = 0;
    std::vector<int> samples;
    QObject::connect(&view().frames(), &FrameLoop::frameDrawn, &view(), [&] {
        compiled += view().frames().report().compiled;
        samples.push_back(view().frames().samples());
    });
    for (const double turn : {3.0, 6.0, 9.0}) {
        const int frames = view().frames().frameCount();
        document().setValue(path, "rotate", turn);
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return view().frames().frameCount() > frames; }, limitMs));
    }
    EXPECT_EQ(samples, std::vector<int>({0, 0, 0}));
    const double fitted = brightness();
    std::vector<double> shown;
    while (view().frames().samples() < wanted) {
        const int frames = view().frames().frameCount();
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return view().frames().frameCount() > frames; }, limitMs));
        shown.push_back(brightness());
    }
    EXPECT_GT(shown.size(), 2U);
    for (const double each : shown) {
        EXPECT_NEAR(each / fitted, 1.0, 0.02);
    }
    EXPECT_EQ(compiled, 0);
}

TEST_F(EnvironmentInTheWindow, TurnedCamera_SeesFittedLightUntilItRests) {
    view().setFixedSize(160, 120);
    document().setBlock(pathOf(kinds::environment), "studio");
    ASSERT_TRUE(waitForSamples(24));
    QSignalSpy frames(&view().frames(), &FrameLoop::frameDrawn);
    drag(Qt::LeftButton, Qt::NoModifier, {40, 0});
    ASSERT_TRUE(frames.wait());
    EXPECT_EQ(view().frames().samples(), 0);
    EXPECT_EQ(view().frames().report().compiled, 0);
    EXPECT_TRUE(waitForSamples(8));
}

TEST_F(EnvironmentInTheWindow, IntensityDraggedToNothingAndBack_CompilesNothing) {
    view().setFixedSize(160, 120);
    document().setBlock(pathOf(kinds::environment), "studio");
    ASSERT_TRUE(waitForSamples(8));
    int compiled = 0;
    QObject::connect(&view().frames(), &FrameLoop::frameDrawn, &view(),
                     [&] { compiled += view().frames().report().compiled; });
    const BlockPath path = document().selection().currentPath(kinds::environment);
    const int token = document().interaction().begin(ParameterTarget{path, "intensity"});
    for (const double intensity : {0.6, 0.0, 0.3}) {
        const int frames = view().frames().frameCount();
        document().setValue(path, "intensity", intensity);
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return view().frames().frameCount() > frames; }, limitMs));
    }
    EXPECT_EQ(compiled, 0);
    document().interaction().end(token);
}

TEST_F(EnvironmentInTheWindow, StatusLine_TellsHowFarItIs) {
    document().setBlock(pathOf(kinds::environment), "studio");
    auto* label = window().statusBar()->findChild<QLabel*>("statusSamples");
    ASSERT_NE(label, nullptr);
    EXPECT_TRUE(QTest::qWaitFor([&] { return label->text().contains("of 1024"); }, limitMs));
}

TEST_F(EnvironmentInTheWindow, DroppedPanorama_LightsTheScene) {
    window().files().drop({QString::fromStdString(panorama())}, Side::A);
    ASSERT_TRUE(document().scene().part(kinds::environment));
    EXPECT_EQ(environmentPicture(document(), Side::A), home("sky.hdr").string());
    EXPECT_TRUE(waitForSamples(8));
    EXPECT_EQ(window().messages().count(), 0);
}

TEST_F(EnvironmentInTheWindow, EnvironmentOfAViewsOwn_HasThePictureThatIsDroppedThere) {
    const std::string ofScene = panorama();
    const std::string ofB = panorama("lamp.hdr");
    EnvironmentLibrary library;
    for (const std::string& file : {ofScene, ofB}) {
        EXPECT_FALSE(library.image(file));
        ASSERT_TRUE(QTest::qWaitFor([&] { return !library.isLoading(); }, limitMs));
    }
    EXPECT_TRUE(library.image(ofScene) && library.image(ofB)) << "two views show them";
    library.keep({ofB});
    EXPECT_FALSE(library.image(ofScene));

    setEnvironmentPicture(document(), ofScene);
    window().comparison().setComparing(true);
    OwnView own;
    own.hasEnvironment = true;
    setOwnView(document(), Side::B, own, "");
    EXPECT_FALSE(document().scene(Side::B).part(kinds::environment));
    document().selection().setSide(Side::B);
    setEnvironmentPicture(document(), ofB);
    EXPECT_EQ(environmentPicture(document(), Side::A), ofScene);
    EXPECT_EQ(environmentPicture(document(), Side::B), ofB);
    const BlockPath path = document().selection().currentPath(kinds::environment);
    EXPECT_TRUE(path.isOfView);
    document().setValue(path, "rotate", 90.0);
    EXPECT_EQ(document().scene(Side::B).part(kinds::environment)->parameters.at("rotate"),
              Value(90.0));
    EXPECT_NE(document().scene().part(kinds::environment)->parameters.at("rotate"), Value(90.0));
}

TEST_F(EnvironmentInTheWindow, PanoramaBesideAPreset_IsLaidOnItWithoutAQuestion) {
    const std::string preset = otherPreset(document()).string();
    window().files().open({QString::fromStdString(panorama()), QString::fromStdString(preset)},
                          Side::A);
    EXPECT_EQ(environmentPicture(document(), Side::A), home("sky.hdr").string());
}

TEST_F(EnvironmentInTheWindow, PanoramaThatCannotBeRead_IsAMessageAndStays) {
    window().files().drop({QString::fromStdString(home("none.exr").string())}, Side::A);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window().messages().count() > 0; }, limitMs));
    EXPECT_EQ(environmentPicture(document(), Side::A), home("none.exr").string());
}

/// Red and blue fields stand behind the objects.
TEST_F(EnvironmentInTheWindow, PanoramaThatCannotBeRead_ShowsAPlaceholder) {
    window().files().drop({QString::fromStdString(home("none.exr").string())}, Side::A);
    ASSERT_TRUE(waitForSamples(8));
    ASSERT_TRUE(QTest::qWaitFor([&] { return window().messages().count() > 0; }, limitMs));
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().frames().isUpToDate(); }, limitMs));
    const Image picture = view().linearPicture();
    ASSERT_FALSE(picture.pixels.empty());
    int fields = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
        fields += picture.pixels[i] > 0.9f && picture.pixels[i + 1] < 0.2f;
    }
    EXPECT_GT(fields, 100);
}

/// What only adds to a picture is no reason to wait.
TEST_F(EnvironmentInTheWindow, PictureTakenWhileItSettles_HasTheSamplesThatAreShown) {
    view().setFixedSize(160, 120);
    document().setBlock(pathOf(kinds::environment), "studio");
    ASSERT_TRUE(waitForSamples(24));
    const int frames = view().frames().frameCount();
    const int samples = view().frames().samples();
    ASSERT_FALSE(view().linearPicture().pixels.empty());
    EXPECT_EQ(view().frames().frameCount(), frames);
    EXPECT_EQ(view().frames().samples(), samples);
    EXPECT_TRUE(waitForSamples(samples + 8));
}

TEST_F(EnvironmentInTheWindow, ChosenAndTurnedOff_AreStepsThatUndo) {
    const int before = document().undoStack().count();
    document().setBlock(pathOf(kinds::environment), "studio");
    document().setValue(document().selection().currentPath(kinds::environment), "rotate", 30.0);
    document().setBlock(pathOf(kinds::environment), "");
    EXPECT_EQ(document().undoStack().count(), before + 3);
    document().undoStack().undo();
    EXPECT_EQ(document().scene().part(kinds::environment)->parameters.at("rotate"), Value(30.0));
    document().undoStack().setIndex(before);
    EXPECT_FALSE(document().scene().part(kinds::environment));
}

TEST_F(EnvironmentInTheWindow, ShiftRightDrag_TurnsItInOneStep) {
    document().setBlock(pathOf(kinds::environment), "studio");
    const int before = document().undoStack().count();
    const Camera camera = view().camera();
    drag(Qt::RightButton, Qt::ShiftModifier, {50, 30});
    const auto turned = [this] {
        const auto& values = document().scene().part(kinds::environment)->parameters;
        const auto found = values.find("rotate");
        return found == values.end() ? 0.0 : std::get<double>(found->second);
    };
    EXPECT_NEAR(turned(), 20.0, 1e-6);
    EXPECT_EQ(view().camera(), camera);
    EXPECT_EQ(document().undoStack().count(), before + 1);
    document().undoStack().undo();
    EXPECT_EQ(turned(), 0.0);
}

TEST_F(EnvironmentInTheWindow, ShiftRightDragWithoutOne_ChangesNothing) {
    const int before = document().undoStack().count();
    const Camera camera = view().camera();
    drag(Qt::RightButton, Qt::ShiftModifier, {50, 0});
    EXPECT_EQ(document().undoStack().count(), before);
    EXPECT_EQ(view().camera(), camera);
}

TEST_F(EnvironmentInTheWindow, TurnedOnAgain_HasItsValues) {
    document().setBlock(pathOf(kinds::environment), "studio");
    document().setValue(document().selection().currentPath(kinds::environment), "rotate", 30.0);
    document().setBlock(pathOf(kinds::environment), "");
    document().setBlock(pathOf(kinds::environment), "studio");
    EXPECT_EQ(document().scene().part(kinds::environment)->parameters.at("rotate"), Value(30.0));
}

TEST_F(EnvironmentInTheWindow, LampsTakenOutInTheMenu_AreLightsWithShadowsInOneStep) {
    document().setBlock(pathOf(kinds::environment), "studio");
    ASSERT_TRUE(waitForSamples(8));
    const std::size_t lights = document().scene().lights.size();
    const int before = document().undoStack().count();
    for (QAction* action : window().findChildren<QAction*>()) {
        if (action->text() == "Take Lamps &Out of the Environment") {
            action->trigger();
        }
    }
    EXPECT_EQ(document().undoStack().count(), before + 1);
    ASSERT_GT(document().scene().lights.size(), lights);
    EXPECT_TRUE(document().scene().lights.back().part(kinds::shadows));
    EXPECT_NE(document().scene().part(kinds::environment)->parameters.at("limit"), Value(0.0));
    document().undoStack().undo();
    EXPECT_EQ(document().scene().lights.size(), lights);
}

TEST_F(EnvironmentInTheWindow, LampsOfAnEnvironmentWithoutAny_AreAMessage) {
    window().files().drop({QString::fromStdString(panorama())}, Side::A);
    ASSERT_TRUE(waitForSamples(8));
    const int before = document().undoStack().count();
    takeLampsOut(document(), window().views(), window().messages());
    EXPECT_EQ(document().undoStack().count(), before);
    EXPECT_EQ(window().messages().count(), 1);
}

TEST_F(EnvironmentInTheWindow, PanoramaDroppedOnTheChooser_JoinsTheListAndLightsTheSceneInOneStep) {
    window().dock("environment")->show();
    window().dock("environment")->raise();
    newFrames();
    auto* chooser = window().dock("environment")->findChild<EnvironmentChooser*>();
    ASSERT_NE(chooser, nullptr);
    const int before = document().undoStack().count();
    QMimeData dragged;
    dragged.setUrls({QUrl::fromLocalFile(QString::fromStdString(panorama()))});
    const QPoint middle = chooser->rect().center();
    QDragEnterEvent enter(middle, Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(chooser, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(middle, Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(chooser, &drop);
    EXPECT_EQ(environmentPicture(document(), Side::A), home("sky.hdr").string());
    EXPECT_EQ(document().undoStack().count(), before + 1);
    EXPECT_EQ(chooser->currentText(), "sky");
    EXPECT_EQ(Session().environments(), QStringList{QString::fromStdString(panorama())});
    document().setBlock(pathOf(kinds::environment), "studio");
    EXPECT_GE(chooser->findText("sky"), 0); // to be chosen again
}

TEST_F(EnvironmentInTheWindow, ListOfEnvironments_HasAPictureOfEach) {
    window().dock("environment")->show();
    window().dock("environment")->raise();
    newFrames();
    auto* chooser = window().dock("environment")->findChild<EnvironmentChooser*>();
    ASSERT_NE(chooser, nullptr);
    chooser->add(QString::fromStdString(panorama()));
    const auto isPictured = [&](const char* text) {
        const QImage shown =
            chooser->itemIcon(chooser->findText(text)).pixmap(QSize(128, 64)).toImage();
        return !shown.isNull() && shown.pixelColor(shown.rect().center()).alpha() == 255;
    };
    EXPECT_FALSE(isPictured("Sky"));
    window().startRest(); // pictures come after the first frame
    chooser->showPopup();
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return isPictured("Sky") && isPictured("Studio") && isPictured("sky"); }, limitMs));
    chooser->hidePopup();
}

TEST_F(EnvironmentInTheWindow, Dock_OffersEveryKindAndOff) {
    QDockWidget* dock = window().dock("environment");
    ASSERT_NE(dock, nullptr);
    dock->show();
    dock->raise();
    newFrames();
    auto* chooser = dock->findChild<BlockChooser*>();
    ASSERT_NE(chooser, nullptr);
    EXPECT_EQ(chooser->count(),
              1 + static_cast<int>(document().catalog().ofKind("environment").size()));
}

} // namespace
} // namespace patina::tests::environment_test
