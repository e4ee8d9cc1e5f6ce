// SPDX-License-Identifier: GPL-3.0-or-later
// How transparent objects are put together: chosen, undone, and kept, in the window.
#include <QDockWidget>
#include <QTest>

#include "docks/block_chooser.h"
#include "ui/window_fixture.h"

namespace patina::tests::transparency_test {
namespace {

constexpr int limitMs = 120000;

class TransparencyInTheWindow : public WindowFixture {
  protected:
    BlockChooser* chooser() {
        QDockWidget* dock = window().dock("opacity");
        dock->show();
        dock->raise();
        newFrames();
        return dock->findChild<BlockChooser*>("order");
    }
};

TEST_F(TransparencyInTheWindow, Chooser_OffersSortedAndEveryKind) {
    ASSERT_NE(chooser(), nullptr);
    EXPECT_EQ(chooser()->count(),
              1 + static_cast<int>(document().catalog().ofKind("transparency").size()));
    EXPECT_EQ(chooser()->currentText(), "Sorted by object");
}

TEST_F(TransparencyInTheWindow, Chosen_IsShownAndUndoneInOneStep) {
    BlockChooser* shown = chooser();
    const int before = document().undoStack().count();
    document().setBlock(pathOf(kinds::transparency), "peeled");
    EXPECT_EQ(document().undoStack().count(), before + 1);
    EXPECT_EQ(shown->currentData().toString(), "peeled");
    document().undoStack().undo();
    EXPECT_FALSE(document().scene().part(kinds::transparency));
    EXPECT_EQ(shown->currentText(), "Sorted by object");
}

TEST_F(TransparencyInTheWindow, ChosenAgain_HasItsValues) {
    document().setBlock(pathOf(kinds::transparency), "peeled");
    document().setValue(document().selection().currentPath(kinds::transparency), "layers", 3);
    document().setBlock(pathOf(kinds::transparency), "");
    document().setBlock(pathOf(kinds::transparency), "peeled");
    EXPECT_EQ(document().scene().part(kinds::transparency)->parameters.at("layers"), Value(3));
}

TEST_F(TransparencyInTheWindow, OpacityDraggedToOneAndBack_CompilesNothing) {
    view().setFixedSize(160, 120);
    document().setBlock(pathOf(kinds::transparency), "peeled");
    const BlockPath path = document().selection().currentPath(settings::material);
    document().setValue(path, "opacity", 0.5);
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().frames().isUpToDate(); }, limitMs));
    int compiled = 0;
    QObject::connect(&view().frames(), &FrameLoop::frameDrawn, &view(),
                     [&] { compiled += view().frames().report().compiled; });
    const int token = document().interaction().begin(ParameterTarget{path, "opacity"});
    for (const double opacity : {0.8, 1.0, 0.0, 0.3}) {
        const int frames = view().frames().frameCount();
        document().setValue(path, "opacity", opacity);
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return view().frames().frameCount() > frames; }, limitMs));
    }
    EXPECT_EQ(compiled, 0);
    document().interaction().end(token);
}

} // namespace
} // namespace patina::tests::transparency_test
