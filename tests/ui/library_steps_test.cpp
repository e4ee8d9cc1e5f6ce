// SPDX-License-Identifier: GPL-3.0-or-later
// Arrow keys that go through the library while two materials are compared.
#include <QToolButton>

#include "ui/preset_window.h"

namespace patina::tests::library_steps_test {
namespace {

class LibrarySteps : public PresetWindow {
  protected:
    void compare() {
        window().comparison().setComparing(true);
        view().setFocus();
    }

    /// Chooses presets for both sides that stand `a` and `b` in the list.
    void compare(int a, int b) {
        compare();
        put(Side::A, a);
        put(Side::B, b);
    }

    void put(Side side, int row) {
        window().files().applyPreset(view().shown().at(static_cast<std::size_t>(row))->path, side);
        ASSERT_EQ(nameOn(side), shown(row));
    }

    void press(QWidget& widget, Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&widget, key, modifiers);
    }

    QString nameOn(Side side) { return QString::fromStdString(document().material(side)->name); }

    QToolButton& next() { return *window().findChild<QToolButton*>("nextPreset"); }
};

TEST_F(LibrarySteps, ArrowsInTheLibrary_GoOnOnBAndWithShiftOnA) {
    ASSERT_NO_FATAL_FAILURE(compare(2, 7));
    press(view(), Qt::Key_Right);
    EXPECT_EQ(nameOn(Side::B), shown(8));
    press(view(), Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_EQ(nameOn(Side::A), shown(1));
    EXPECT_EQ(nameOn(Side::B), shown(8));
    EXPECT_EQ(view().selected().size(), 1u);
    document().undoStack().undo();
    EXPECT_EQ(nameOn(Side::A), shown(2));
}

TEST_F(LibrarySteps, AmongPresetsThatWereSearched_AreTheirs) {
    ASSERT_NO_FATAL_FAILURE(compare());
    QTest::keyClicks(&search(), "gold");
    ASSERT_GE(count(), 2);
    ASSERT_NO_FATAL_FAILURE(put(Side::B, count() - 1));
    view().setFocus();
    press(view(), Qt::Key_Right);
    EXPECT_EQ(nameOn(Side::B), shown(0)) << "after the last one comes the first";
}

TEST_F(LibrarySteps, WithoutAComparison_ArrowsTryPresetsAndShiftSelects) {
    click(1);
    press(view(), Qt::Key_Right);
    EXPECT_EQ(seen().name, shown(2).toStdString());
    press(view(), Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_EQ(view().selected().size(), 2u);
    EXPECT_EQ(edits(), 0);
}

TEST_F(LibrarySteps, ArrowsAndClicksInTheBar_DoTheSame) {
    ASSERT_NO_FATAL_FAILURE(compare());
    const QString first = nameOn(Side::B);
    press(next(), Qt::Key_Right);
    const QString second = nameOn(Side::B);
    EXPECT_NE(second, first);
    press(next(), Qt::Key_Up);
    EXPECT_EQ(nameOn(Side::B), first);
    QTest::mouseClick(&next(), Qt::LeftButton);
    EXPECT_EQ(nameOn(Side::B), second);
    EXPECT_EQ(nameOn(Side::A), first);
    press(next(), Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_EQ(nameOn(Side::A), second);
}

TEST_F(LibrarySteps, ArrowsInAView_MoveTheCamera) {
    ASSERT_NO_FATAL_FAILURE(compare());
    const int before = edits();
    const Camera camera = document().scene().camera;
    press(WindowFixture::view(), Qt::Key_Right);
    EXPECT_NE(document().scene().camera, camera);
    EXPECT_EQ(edits(), before);
}

} // namespace
} // namespace patina::tests::library_steps_test
