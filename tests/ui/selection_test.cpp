// SPDX-License-Identifier: GPL-3.0-or-later
// Objects are selected by clicks, and what is done then is done to all of them.
#include <QDockWidget>
#include <QPainter>
#include <QTest>

#include "docks/check_list.h"
#include "document/scene_edits.h"
#include "ui/window_fixture.h"
#include "viewport/ray_cast.h"
#include "viewport/side_view.h"
#include "viewport/view_overlay.h"

namespace patina::tests::selection_test {
namespace {

/// A cube on the left and one on the right of the shader ball.
class Selection : public WindowFixture {
  protected:
    Selection() {
        window().views().handleModes().setShowsLights(false);
        for (const double x : {-2.5, 2.5}) {
            Object cube;
            cube.name = "Cube";
            cube.mesh = "builtin:cube";
            cube.translation = {x, 0.0, 0.0};
            cube.scale = glm::dvec3(0.5);
            cube.material = document().scene().objects[0].material;
            addObject(document(), cube);
        }
        window().views().first().frameCurrentObject();
        Camera camera = document().scene().camera;
        camera.pivot = glm::dvec3(0.0);
        camera.distance = 12.0;
        camera.yaw = 0.0;
        document().setCamera(camera);
        newFrames();
        focusView();
    }

    QPoint placeOf(int object) {
        const auto place = patina::placeOf(
            camera(), document().scene().objects[static_cast<std::size_t>(object)].translation,
            {view().width(), view().height()});
        return {static_cast<int>(place->x), static_cast<int>(place->y)};
    }
    void click(int object, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::mouseClick(&view(), Qt::LeftButton, modifiers, placeOf(object));
    }
    ViewOverlay& overlay() { return *view().findChild<ViewOverlay*>(); }
    const std::vector<int>& selected() { return document().selection().objects(); }
    double visibleObjects() {
        return double(std::ranges::count(document().scene().objects, true, &Object::visible));
    }
};

TEST_F(Selection, Click_SelectsTheObjectUnderThePointer) {
    click(1);
    EXPECT_EQ(selected(), std::vector<int>{1});
    EXPECT_EQ(document().selection().object(), 1);
    click(2);
    EXPECT_EQ(selected(), std::vector<int>{2});
}

TEST_F(Selection, Click_DrawsLinesAroundTheObjectOnly) {
    EXPECT_FALSE(overlay().isSeen());
    click(1);
    ASSERT_TRUE(overlay().isSeen());
    QImage lines(view().size(), QImage::Format_ARGB32_Premultiplied);
    lines.fill(Qt::transparent);
    QPainter painter(&lines);
    overlay().draw(painter);
    painter.end();
    int left = 0;
    int elsewhere = 0;
    for (int y = 0; y < lines.height(); ++y) {
        for (int x = 0; x < lines.width(); ++x) {
            if (lines.pixelColor(x, y).alpha() > 0) {
                ++(std::abs(x - placeOf(1).x()) < 50 ? left : elsewhere);
            }
        }
    }
    EXPECT_GT(left, 60);
    EXPECT_EQ(elsewhere, 0);
}

TEST_F(Selection, ClickBesideEverything_KeepsTheCurrentObject) {
    click(1);
    QTest::mouseClick(&view(), Qt::LeftButton, Qt::NoModifier, {3, 3});
    EXPECT_TRUE(selected().empty());
    EXPECT_EQ(document().selection().object(), 1);
    EXPECT_FALSE(overlay().isSeen());
}

TEST_F(Selection, CtrlClick_AddsAndTakesAway) {
    click(1);
    click(2, Qt::ControlModifier);
    EXPECT_EQ(selected(), (std::vector<int>{1, 2}));
    click(1, Qt::ControlModifier);
    EXPECT_EQ(selected(), std::vector<int>{2});
}

TEST_F(Selection, Drag_SelectsNothing) {
    drag(Qt::LeftButton, Qt::NoModifier, {40, 10});
    EXPECT_TRUE(selected().empty());
}

TEST_F(Selection, EditOfAValue_IsOneStepOfAllSelected) {
    click(1);
    click(2, Qt::ControlModifier);
    const int steps = document().undoStack().count();
    const DocumentState before = document().state();
    document().interaction().begin();
    for (const double red : {0.3, 0.2, 0.1}) {
        document().setValue(document().selection().currentPath(kinds::models), "diffuse.color",
                            glm::dvec3(red, 0.5, 0.5));
    }
    document().interaction().end();
    const auto color = [this](std::size_t i) {
        return document().scene().objects[i].material.model.parameters.at("diffuse.color");
    };
    EXPECT_EQ(document().undoStack().count(), steps + 1);
    EXPECT_EQ(color(1), color(2));
    EXPECT_NE(color(1), color(0));
    document().undoStack().undo();
    EXPECT_EQ(document().state(), before);
}

TEST_F(Selection, DragBackToTheStart_LeavesNoStep) {
    click(1);
    click(2, Qt::ControlModifier);
    const int steps = document().undoStack().count();
    const BlockPath path = document().selection().currentPath(settings::object);
    const Value start = document().value(path, *document().block(path)->parameter("rotation"));
    document().interaction().begin();
    document().setValue(path, "rotation", glm::dvec3(20.0));
    document().setValue(path, "rotation", start);
    document().interaction().end();
    EXPECT_EQ(document().undoStack().count(), steps);
}

TEST_F(Selection, AnotherModel_IsOneStepOfAllSelected) {
    click(1);
    click(2, Qt::ControlModifier);
    const int steps = document().undoStack().count();
    document().setModel(Side::A, "oren-nayar");
    EXPECT_EQ(document().scene().objects[1].material.model.id, "oren-nayar");
    EXPECT_EQ(document().scene().objects[2].material.model.id, "oren-nayar");
    EXPECT_EQ(document().undoStack().count(), steps + 1);
}

TEST_F(Selection, ShiftD_AddsACopyBesideAndSelectsIt) {
    click(2);
    QTest::keyClick(&view(), Qt::Key_D, Qt::ShiftModifier);
    ASSERT_EQ(document().scene().objects.size(), 4u);
    EXPECT_EQ(selected(), std::vector<int>{3});
    const Object& copy = document().scene().objects[3];
    EXPECT_EQ(copy.name, "Cube 2");
    EXPECT_GT(copy.translation.x, 3.0);
    EXPECT_EQ(copy.material, document().scene().objects[2].material);
}

TEST_F(Selection, HAndAltH_HideTheSelectedAndShowAll) {
    click(1);
    click(2, Qt::ControlModifier);
    QTest::keyClick(&view(), Qt::Key_H);
    EXPECT_EQ(visibleObjects(), 1);
    QTest::keyClick(&view(), Qt::Key_H, Qt::AltModifier);
    EXPECT_EQ(visibleObjects(), 3);
}

TEST_F(Selection, Delete_RemovesAllSelectedInOneStep) {
    const std::vector<Object> before = document().scene().objects;
    const int steps = document().undoStack().count();
    click(1);
    click(2, Qt::ControlModifier);
    QTest::keyClick(&view(), Qt::Key_Delete);
    EXPECT_EQ(document().scene().objects.size(), 1u);
    EXPECT_EQ(document().undoStack().count(), steps + 1);
    document().undoStack().undo();
    EXPECT_EQ(document().scene().objects, before);
}

TEST_F(Selection, UndoSteps_SayHowManyObjectsTheyAreOf) {
    const auto undone = [this] { return document().undoStack().undoText(); };
    click(1);
    QTest::keyClick(&view(), Qt::Key_H);
    EXPECT_EQ(undone(), "Hide object");
    document().undoStack().undo();
    click(2, Qt::ControlModifier);
    QTest::keyClick(&view(), Qt::Key_H);
    EXPECT_EQ(undone(), "Hide 2 objects");
    document().undoStack().undo();
    QTest::keyClick(&view(), Qt::Key_G, Qt::ControlModifier);
    EXPECT_EQ(undone(), "Group 2 objects");
    QTest::keyClick(&view(), Qt::Key_D, Qt::ShiftModifier);
    EXPECT_EQ(undone(), "Duplicate 2 objects");
    document().undoStack().undo();
    removeObjects(document(), {0});
    EXPECT_EQ(undone(), "Remove object");
}

TEST_F(Selection, Group_IsSelectedByAClickOnOneOfThem) {
    click(1);
    click(2, Qt::ControlModifier);
    QTest::keyClick(&view(), Qt::Key_G, Qt::ControlModifier);
    click(0);
    click(2);
    EXPECT_EQ(selected(), (std::vector<int>{1, 2}));
    QTest::keyClick(&view(), Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
    click(2);
    EXPECT_EQ(selected(), std::vector<int>{2});
}

TEST_F(Selection, CtrlClickInTheList_SelectsSeveral) {
    window().dock("scene")->show();
    window().dock("scene")->raise();
    settle();
    auto* list = window().dock("scene")->findChild<CheckList*>();
    ASSERT_NE(list, nullptr);
    const auto clickRow = [list](int row, Qt::KeyboardModifiers modifiers) {
        QTest::mouseClick(list->viewport(), Qt::LeftButton, modifiers,
                          list->visualItemRect(list->item(row)).center());
    };
    clickRow(0, Qt::NoModifier);
    clickRow(2, Qt::ControlModifier);
    EXPECT_EQ(selected(), (std::vector<int>{0, 2}));
    EXPECT_EQ(document().selection().object(), 2);
    clickRow(1, Qt::NoModifier);
    EXPECT_EQ(selected(), std::vector<int>{1});
}

TEST_F(Selection, F_FramesTheSelectedAndOnceMoreAll) {
    click(1);
    QTest::keyClick(&view(), Qt::Key_F);
    const Camera onOne = camera();
    EXPECT_NEAR(onOne.pivot.x, -2.5, 0.3);
    QTest::keyClick(&view(), Qt::Key_F);
    EXPECT_GT(camera().distance, 1.5 * onOne.distance);
    EXPECT_NEAR(camera().pivot.x, 0.0, 0.3);
}

} // namespace
} // namespace patina::tests::selection_test
