// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <QAbstractItemView>
#include <QDockWidget>
#include <QLabel>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>

#include "document/scene_edits.h"
#include "ui/window_fixture.h"
#include "viewport/side_view.h"

namespace patina::tests::viewport_test {
namespace {

using Viewports = WindowFixture;

constexpr int idleMs = 10000;

TEST_F(Viewports, LeftAloneForTenSeconds_DrawNothing) {
    QTest::qWait(idleMs);
    EXPECT_EQ(newFrames(), 0);
}

TEST_F(Viewports, ManyChangesInOneTurn_DrawOneFrame) {
    const BlockPath path = document().selection().currentPath(settings::scene);
    for (int i = 1; i <= 50; ++i) {
        document().setValue(path, "exposure", 0.01 * i);
    }
    EXPECT_EQ(newFrames(), 1);
}

TEST_F(Viewports, OnceShown_HaveDrawnOneFrame) {
    EXPECT_EQ(view().frames().frameCount(), 1);
}

TEST_F(Viewports, Resized_DrawOneFrameInTheNewSize) {
    QSignalSpy frames(&view().frames(), &FrameLoop::frameDrawn);
    window().resize(window().size() - QSize(60, 40));
    ASSERT_TRUE(frames.wait());
    newFrames();
    EXPECT_EQ(view().grabPicture().size(), view().size());
    EXPECT_EQ(frames.count(), 1);
}

/// The picture as it is now; grabbing it would paint first.
QColor middleOf(Viewport& view) {
    const QImage shown = view.frames().surface().picture();
    return shown.pixelColor(shown.rect().center());
}

TEST_F(Viewports, Resized_ShowTheirLastPictureUntilTheNextFrame) {
    const int frames = view().frames().frameCount();
    const QColor before = middleOf(view());
    view().resize(view().size() - QSize(0, 100));
    const QColor after = middleOf(view());
    EXPECT_EQ(view().frames().frameCount(), frames);
    EXPECT_GT(before.lightness(), 30);
    EXPECT_LT(std::abs(after.lightness() - before.lightness()), 30);
}

/// The share of the way between black and white by which the pictures differ on average.
double difference(const QImage& a, const QImage& b) {
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            sum += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
        }
    }
    return sum / 255.0 / a.width() / a.height();
}

TEST_F(Viewports, NewSceneOnASlowDevice_ShowASketchBeforeTheWholeFrame) {
    const QImage whole = view().grabPicture();
    QSignalSpy frames(&view().frames(), &FrameLoop::frameDrawn);
    QImage sketch;
    int framesBefore = -1;
    QObject::connect(&view().frames(), &FrameLoop::sketchDrawn, &view(), [&] {
        framesBefore = int(frames.count());
        sketch = view().frames().surface().picture();
    });
    view().frames().announceScene();
    ASSERT_TRUE(frames.wait());
    newFrames();
    EXPECT_EQ(view().grabPicture(), whole);
    if (sketch.isNull()) { // a device that takes next to nothing for a whole frame
        EXPECT_LT(view().frames().stopwatch().text().split(' ').first().toDouble(), 50.0);
        return;
    }
    EXPECT_EQ(framesBefore, 0);
    EXPECT_LT(difference(sketch, whole), 0.02);
    EXPECT_NE(sketch.convertToFormat(whole.format()), whole);
}

TEST_F(Viewports, Repainted_KeepTheirPictureWithoutAFrame) {
    const QImage before = view().grabPicture();
    newFrames();
    view().update();
    EXPECT_EQ(newFrames(), 0);
    EXPECT_EQ(view().grabPicture(), before);
}

TEST_F(Viewports, ComparedForTheFirstTime_NameWhatTheyShow) {
    window().comparison().setComparing(true);
    settle();
    const auto views = window().findChildren<SideView*>();
    ASSERT_EQ(views.size(), 2);
    for (SideView* each : views) {
        const QLabel& title = *each->findChild<QLabel*>("title");
        EXPECT_TRUE(title.text().contains(title.toolTip().left(4))) << title.text().toStdString();
    }
}

TEST_F(Viewports, ViewAAtTheStart_SaysWhatItShows) {
    EXPECT_TRUE(view().accessibleDescription().contains(
        QString::fromStdString(document().material(Side::A)->name)))
        << view().accessibleDescription().toStdString();
}

TEST_F(Viewports, NarrowerThanHigh_ShowTheWholeObject) {
    window().dock("parameters")->hide();
    window().dock("lights")->hide();
    window().resize(620, 900);
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().height() > 700; }));
    newFrames();
    ASSERT_LT(view().width(), 0.7 * view().height());
    const Object& object = document().scene().objects[0];
    const double edge =
        std::tan(0.5 * glm::radians(camera().fieldOfView)) * view().width() / view().height();
    double farthest = 0.0;
    for (const Vertex& vertex : window().meshes().view(object).vertices) {
        const glm::dvec4 seen =
            viewMatrix(camera()) * worldMatrix(object) * glm::dvec4(vertex.position, 1.0);
        farthest = std::max(farthest, std::abs(seen.x / seen.z / edge));
    }
    EXPECT_GT(farthest, 0.5);
    EXPECT_LT(farthest, 1.0);
    EXPECT_FALSE(document().isModified());
}

TEST_F(Viewports, KeyFOnceMore_FramesAllObjects) {
    Object other = document().scene().objects[0];
    other.translation.x += 4.0;
    addObject(document(), other);
    QTest::keyClick(&view(), Qt::Key_F);
    const Camera onOne = camera();
    EXPECT_NEAR(onOne.pivot.x, other.translation.x, 0.5);
    QTest::keyClick(&view(), Qt::Key_F);
    EXPECT_GT(camera().distance, onOne.distance);
    EXPECT_NEAR(camera().pivot.x, other.translation.x - 2.0, 0.5);
    QTest::keyClick(&view(), Qt::Key_F);
    EXPECT_NEAR(camera().distance, onOne.distance, 1e-6);
}

TEST_F(Viewports, LeftDrag_Orbits) {
    const Camera before = camera();
    drag(Qt::LeftButton, Qt::NoModifier, {40, 0});
    EXPECT_NE(camera().yaw, before.yaw);
    EXPECT_EQ(camera().pivot, before.pivot);
}

TEST_F(Viewports, MiddleDrag_Pans) {
    const Camera before = camera();
    drag(Qt::MiddleButton, Qt::NoModifier, {40, 10});
    EXPECT_NE(camera().pivot, before.pivot);
    EXPECT_EQ(camera().yaw, before.yaw);
}

TEST_F(Viewports, ShiftLeftDrag_Pans) {
    const Camera before = camera();
    drag(Qt::LeftButton, Qt::ShiftModifier, {40, 10});
    EXPECT_NE(camera().pivot, before.pivot);
}

TEST_F(Viewports, RightDragUp_MovesNearer) {
    const Camera before = camera();
    drag(Qt::RightButton, Qt::NoModifier, {0, -40});
    EXPECT_LT(camera().distance, before.distance);
}

TEST_F(Viewports, AltMiddleDrag_PansAsInMaya) {
    const Camera before = camera();
    drag(Qt::MiddleButton, Qt::AltModifier, {40, 0});
    EXPECT_NE(camera().pivot, before.pivot);
}

TEST_F(Viewports, Wheel_MovesNearer) {
    const Camera before = camera();
    const QPointF middle = view().rect().center();
    QWheelEvent turn(middle, view().mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                     Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view(), &turn);
    EXPECT_LT(camera().distance, before.distance);
}

TEST_F(Viewports, KeyF_FramesTheObject) {
    drag(Qt::MiddleButton, Qt::NoModifier, {200, 100});
    const glm::dvec3 panned = camera().pivot;
    QTest::keyClick(&view(), Qt::Key_F);
    EXPECT_LT(glm::length(camera().pivot), glm::length(panned));
}

TEST_F(Viewports, KeyHome_BringsTheFirstCameraBack) {
    const Camera before = camera();
    drag(Qt::LeftButton, Qt::NoModifier, {40, 10});
    QTest::keyClick(&view(), Qt::Key_Home);
    EXPECT_EQ(camera(), before);
}

TEST_F(Viewports, DoubleClickOnTheSurface_SetsThePivotThere) {
    const Camera before = camera();
    const QPoint place = view().rect().center() + QPoint(30, -20);
    QTest::mouseDClick(&view(), Qt::LeftButton, Qt::NoModifier, place);
    EXPECT_NE(camera().pivot, before.pivot);
    EXPECT_NEAR(glm::distance(eye(camera()), eye(before)), 0.0, 1e-9); // rounding of doubles
}

TEST_F(Viewports, CtrlLeftDrag_TurnsTheObjectInOneStep) {
    const glm::dvec3 before = document().scene().objects[0].rotation;
    drag(Qt::LeftButton, Qt::ControlModifier, {60, 20});
    EXPECT_NE(document().scene().objects[0].rotation, before);
    EXPECT_EQ(document().undoStack().count(), 1);
}

TEST_F(Viewports, KeyLAndLeftDrag_TurnsALightInOneStep) {
    const std::vector<Light> before = document().scene().lights;
    QTest::keyPress(&view(), Qt::Key_L);
    drag(Qt::LeftButton, Qt::NoModifier, {60, 20});
    QTest::keyRelease(&view(), Qt::Key_L);
    EXPECT_NE(document().scene().lights, before);
    EXPECT_EQ(document().undoStack().count(), 1);
}

TEST_F(Viewports, KeyLOverTheViewWithTheFocusElsewhere_TurnsALight) {
    const std::vector<Light> before = document().scene().lights;
    auto* elsewhere = window().dock("lights")->findChild<QAbstractItemView*>();
    elsewhere->setFocus();
    QEnterEvent enter(view().rect().center(), view().rect().center(), view().rect().center());
    QApplication::sendEvent(&view(), &enter);
    QTest::keyPress(elsewhere, Qt::Key_L);
    drag(Qt::LeftButton, Qt::NoModifier, {60, 20});
    EXPECT_NE(document().scene().lights, before);
}

TEST_F(Viewports, NumpadSeven_LooksFromAbove) {
    QTest::keyClick(&view(), Qt::Key_7, Qt::KeypadModifier);
    EXPECT_EQ(camera().pitch, 90.0);
}

TEST_F(Viewports, WhileComparing_MoveTogether) {
    window().comparison().setComparing(true);
    drag(Qt::LeftButton, Qt::NoModifier, {40, 0});
    EXPECT_EQ(secondView().camera(), camera());
}

TEST_F(Viewports, ViewsBesideEachOther_AreOfOneSize) {
    window().comparison().setComparing(true);
    QTest::qWait(200); // layouts that were put off
    ASSERT_TRUE(secondView().isVisible());
    EXPECT_EQ(view().height(), secondView().height());
    EXPECT_NEAR(view().width(), secondView().width(), 1);
}

TEST_F(Viewports, Unlinked_MoveAlone) {
    window().comparison().setComparing(true);
    window().views().cameras().setLinked(false);
    const Camera before = secondView().camera();
    drag(Qt::LeftButton, Qt::NoModifier, {40, 0});
    EXPECT_EQ(secondView().camera(), before);
}

TEST_F(Viewports, Realigned_LookFromTheSamePlace) {
    window().comparison().setComparing(true);
    window().views().cameras().setLinked(false);
    drag(Qt::LeftButton, Qt::NoModifier, {40, 0});
    window().views().cameras().realign();
    EXPECT_EQ(secondView().camera(), camera());
}

TEST_F(Viewports, ClickOnB_MakesItActive) {
    window().comparison().setComparing(true);
    QTest::mouseClick(&secondView(), Qt::LeftButton);
    EXPECT_EQ(document().selection().side(), Side::B);
}

TEST_F(Viewports, PresetDroppedOnB_ChangesOnlyB) {
    window().comparison().setComparing(true);
    QTest::qWait(0);
    const Material before = *document().material(Side::A);
    const std::filesystem::path preset = otherPreset(document());
    ASSERT_FALSE(preset.empty());
    QMimeData dragged;
    dragged.setUrls({QUrl::fromLocalFile(QString::fromStdString(preset.string()))});
    const QPoint middle = secondView().rect().center();
    QDragEnterEvent enter(middle, Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&secondView(), &enter);
    QDropEvent drop(middle, Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&secondView(), &drop);
    EXPECT_EQ(*document().material(Side::A), before);
    EXPECT_NE(document().material(Side::B)->model.id, before.model.id);
    EXPECT_EQ(document().selection().side(), Side::B);
}

} // namespace
} // namespace patina::tests::viewport_test
