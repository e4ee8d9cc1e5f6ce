// SPDX-License-Identifier: GPL-3.0-or-later
// What moves the camera of a view, and how its moves are taken back.
#include <QApplication>
#include <QDockWidget>
#include <QTest>
#include <QWheelEvent>

#include "docks/scene_dock.h"
#include "document/scene_edits.h"
#include "parameters/document_form.h"
#include "parameters/number_box.h"
#include "parameters/parameter_row.h"
#include "scene/scene_file.h"
#include "ui/window_fixture.h"
#include "viewport/ray_cast.h"

namespace patina::tests::camera_keys_test {
namespace {

class CameraKeys : public WindowFixture {
  protected:
    CameraKeys() { focusView(); }

    void key(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(&view(), static_cast<Qt::Key>(key), modifiers);
    }
    const QPoint middle() { return view().rect().center(); }
    void pressAndMove(QPoint by, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::mousePress(&view(), Qt::LeftButton, modifiers, middle());
        QMouseEvent move(QEvent::MouseMove, middle() + by, view().mapToGlobal(middle() + by),
                         Qt::NoButton, Qt::LeftButton, modifiers);
        QApplication::sendEvent(&view(), &move);
    }
    int steps() { return document().undoStack().count(); }
};

TEST_F(CameraKeys, Arrows_OrbitAndWithShiftPan) {
    const Camera before = camera();
    key(Qt::Key_Right);
    EXPECT_NE(camera().yaw, before.yaw);
    EXPECT_EQ(camera().pivot, before.pivot);
    key(Qt::Key_Up, Qt::ShiftModifier);
    EXPECT_NE(camera().pivot, before.pivot);
    EXPECT_EQ(steps(), 0);
}

TEST_F(CameraKeys, PlusAndMinus_MoveNearerAndFarther) {
    const double before = camera().distance;
    key(Qt::Key_Plus);
    EXPECT_LT(camera().distance, before);
    key(Qt::Key_Minus);
    key(Qt::Key_Minus);
    EXPECT_GT(camera().distance, before);
}

TEST_F(CameraKeys, Space_ResetsTheView) {
    const Camera before = camera();
    key(Qt::Key_Right);
    key(Qt::Key_Space);
    EXPECT_EQ(camera(), before);
}

TEST_F(CameraKeys, KeypadFive_IsOrthographicAndBack) {
    const Camera before = camera();
    key(Qt::Key_5, Qt::KeypadModifier);
    EXPECT_EQ(camera().fieldOfView, 1.0);
    const double size = pixelsPerMetre(camera(), camera().pivot, view().height());
    EXPECT_NEAR(size, pixelsPerMetre(before, before.pivot, view().height()), 1e-6 * size);
    key(Qt::Key_5, Qt::KeypadModifier);
    EXPECT_EQ(camera().fieldOfView, before.fieldOfView);
    EXPECT_NEAR(camera().distance, before.distance, 1e-9);
}

TEST_F(CameraKeys, AltZ_TakesAWholeDragBackAndShiftAltZMakesItAgain) {
    const Camera before = camera();
    drag(Qt::LeftButton, Qt::NoModifier, {60, 20});
    const Camera after = camera();
    ASSERT_NE(after, before);
    key(Qt::Key_Z, Qt::AltModifier);
    EXPECT_EQ(camera(), before);
    key(Qt::Key_Z, Qt::AltModifier | Qt::ShiftModifier);
    EXPECT_EQ(camera(), after);
}

TEST_F(CameraKeys, CtrlZ_LeavesTheCameraAndAltZTheMaterial) {
    document().setModel(Side::A, "oren-nayar");
    drag(Qt::LeftButton, Qt::NoModifier, {60, 20});
    const Camera moved = camera();
    key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(camera(), moved);
    EXPECT_NE(document().material(Side::A)->model.id, "oren-nayar");
    key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    key(Qt::Key_Z, Qt::AltModifier);
    EXPECT_NE(camera(), moved);
    EXPECT_EQ(document().material(Side::A)->model.id, "oren-nayar");
}

TEST_F(CameraKeys, EscDuringADrag_PutsTheCameraBack) {
    const Camera before = camera();
    pressAndMove({60, 20});
    ASSERT_NE(camera(), before);
    key(Qt::Key_Escape);
    EXPECT_EQ(camera(), before);
    EXPECT_FALSE(window().views().cameras().history().canUndo());
    QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, middle());
    EXPECT_EQ(camera(), before);
}

TEST_F(CameraKeys, EscWhileAnObjectIsTurned_PutsItBackWithoutAStep) {
    const std::vector<Object> before = document().scene().objects;
    pressAndMove({60, 20}, Qt::ControlModifier);
    ASSERT_NE(document().scene().objects, before);
    key(Qt::Key_Escape);
    EXPECT_EQ(document().scene().objects, before);
    EXPECT_EQ(steps(), 0);
    EXPECT_FALSE(document().interaction().isGoingOn());
}

TEST_F(CameraKeys, CtrlWheel_KeepsWhatIsUnderThePointer) {
    const glm::dvec2 size(view().width(), view().height());
    const glm::dvec2 place(0.3 * size);
    const Ray ray = rayThrough(camera(), place, size);
    const glm::dvec3 point = ray.origin + ray.direction * camera().distance;
    const auto before = placeOf(camera(), point, size);
    const double distance = camera().distance;
    const QPointF at(place.x, place.y);
    QWheelEvent wheel(at, view().mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::ControlModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view(), &wheel);
    EXPECT_LT(camera().distance, distance);
    const auto after = placeOf(camera(), point, size);
    ASSERT_TRUE(before && after);
    EXPECT_NEAR(after->x, before->x, 3.0); // the point is not quite as deep as the pivot
    EXPECT_NEAR(after->y, before->y, 3.0);
}

TEST_F(CameraKeys, Digit_GoesToTheViewThatCtrlDigitKept) {
    const Camera kept = camera();
    key(Qt::Key_4, Qt::ControlModifier);
    drag(Qt::LeftButton, Qt::NoModifier, {60, 20});
    key(Qt::Key_3); // none
    EXPECT_NE(camera(), kept);
    key(Qt::Key_4);
    EXPECT_EQ(camera(), kept);
}

TEST_F(CameraKeys, Bookmarks_AreKeptWithTheSceneAndUndone) {
    key(Qt::Key_4, Qt::ControlModifier);
    const Camera kept = document().scene().camera; // a narrow view stands farther back
    const std::filesystem::path file = home("scene.patina-scene.json");
    ASSERT_TRUE(writeScene(file, document().scene()));
    const auto read = readScene(file, document().catalog());
    ASSERT_TRUE(read);
    ASSERT_TRUE(read->scene.bookmarks.contains(4));
    EXPECT_NEAR(read->scene.bookmarks.at(4).distance, kept.distance, 1e-5);
    document().undoStack().undo();
    EXPECT_TRUE(document().scene().bookmarks.empty());
}

TEST_F(CameraKeys, FieldOfViewInThePanel_MovesTheCameraWithoutAnEdit) {
    window().dock("scene")->show();
    window().dock("scene")->raise();
    settle();
    DocumentForm* form = nullptr;
    for (auto* each : window().dock("scene")->findChildren<DocumentForm*>()) {
        form = each->row("fieldOfView") ? each : form;
    }
    ASSERT_NE(form, nullptr);
    auto* box = form->row("fieldOfView")->findChild<NumberBox*>();
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, "60");
    QTest::keyClick(box, Qt::Key_Return);
    EXPECT_EQ(camera().fieldOfView, 60.0);
    EXPECT_EQ(steps(), 0);
    window().views().cameras().history().undo();
    EXPECT_NE(camera().fieldOfView, 60.0);
    EXPECT_FALSE(box->text().startsWith("60"));
}

TEST_F(CameraKeys, NearPlane_CutsAwayWhatIsBeforeIt) {
    const QImage whole = view().grabPicture();
    const BlockPath path = document().selection().currentPath(settings::camera);
    document().setValue(path, "near", camera().distance + 100.0);
    newFrames();
    const QImage cut = view().grabPicture();
    EXPECT_NE(cut.pixel(cut.rect().center()), whole.pixel(whole.rect().center()));
    EXPECT_EQ(cut.pixel(cut.rect().center()), cut.pixel(2, 2));
    document().setValue(path, "near", 0.0);
    newFrames();
    EXPECT_EQ(view().grabPicture(), whole);
}

} // namespace
} // namespace patina::tests::camera_keys_test
