// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a material: chosen, undone and dragged, in the window.
#include <QDockWidget>
#include <QTest>

#include "docks/block_chooser.h"
#include "ui/window_fixture.h"

namespace patina::tests::outline_test {
namespace {

constexpr int limitMs = 120000;

class OutlineInTheWindow : public WindowFixture {
  protected:
    BlockPath path() { return document().selection().currentPath(kinds::outline); }

    void choose(const std::string& id) {
        document().setBlock(document().selection().currentPath(kinds::outline), id);
    }

    const BlockValues* lines() {
        return document().material(document().selection().side())->part("outline");
    }
};

TEST_F(OutlineInTheWindow, Surface_OffersEveryKind) {
    QDockWidget* dock = window().dock("opacity");
    dock->show();
    dock->raise();
    newFrames();
    const auto choosers = dock->findChildren<BlockChooser*>();
    const auto found = std::ranges::find(choosers, QString("Outline"), &QWidget::accessibleName);
    ASSERT_NE(found, choosers.end());
    EXPECT_EQ((*found)->count(),
              1 + static_cast<int>(document().catalog().ofKind("outline").size()));
    choose("ink-line");
    EXPECT_EQ((*found)->currentData().toString(), "ink-line");
}

TEST_F(OutlineInTheWindow, Chosen_IsUndoneInOneStep) {
    const int before = document().undoStack().count();
    choose("ink-line");
    EXPECT_EQ(document().undoStack().count(), before + 1);
    EXPECT_EQ(document().undoStack().undoText(), "Outline Ink line");
    document().undoStack().undo();
    EXPECT_EQ(lines(), nullptr);
}

TEST_F(OutlineInTheWindow, ChosenAgain_HasItsValues) {
    choose("ink-line");
    document().setValue(path(), "width", 5.0);
    choose("");
    choose("ink-line");
    EXPECT_EQ(lines()->parameters.at("width"), Value(5.0));
}

TEST_F(OutlineInTheWindow, OfAnotherModel_Stays) {
    choose("ink-line");
    document().setModel(document().selection().side(), "gooch");
    EXPECT_NE(lines(), nullptr);
}

TEST_F(OutlineInTheWindow, WidthDraggedToNothingAndBack_CompilesNothing) {
    view().setFixedSize(160, 120);
    choose("ink-line");
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().frames().isUpToDate(); }, limitMs));
    int compiled = 0;
    QObject::connect(&view().frames(), &FrameLoop::frameDrawn, &view(),
                     [&] { compiled += view().frames().report().compiled; });
    const int token = document().interaction().begin(ParameterTarget{path(), "width"});
    for (const double width : {3.0, 0.0, 8.0}) {
        const int frames = view().frames().frameCount();
        document().setValue(path(), "width", width);
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return view().frames().frameCount() > frames; }, limitMs));
    }
    EXPECT_EQ(compiled, 0);
    document().interaction().end(token);
}

} // namespace
} // namespace patina::tests::outline_test
