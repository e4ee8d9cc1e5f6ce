// SPDX-License-Identifier: GPL-3.0-or-later
// How a material bends light: chosen, undone and dragged, in the window.
#include <QDockWidget>
#include <QLabel>
#include <QTest>

#include "docks/block_chooser.h"
#include "docks/refraction_panel.h"
#include "ui/window_fixture.h"

namespace patina::tests::refraction_test {
namespace {

constexpr int limitMs = 120000;

class RefractionInTheWindow : public WindowFixture {
  protected:
    RefractionPanel* panel() {
        QDockWidget* dock = window().dock("opacity");
        dock->show();
        dock->raise();
        newFrames();
        return dock->findChild<RefractionPanel*>();
    }

    void choose(const std::string& id) { document().setBlock(pathOf(kinds::refraction), id); }
};

TEST_F(RefractionInTheWindow, Chosen_IsShownAndUndoneInOneStep) {
    auto* chooser = panel()->findChild<BlockChooser*>();
    const int before = document().undoStack().count();
    choose("solid-body");
    EXPECT_EQ(document().undoStack().count(), before + 1);
    EXPECT_EQ(chooser->currentData().toString(), "solid-body");
    document().undoStack().undo();
    EXPECT_EQ(document().material(Side::A)->part("refraction"), nullptr);
    EXPECT_EQ(chooser->currentText(), "None: straight through");
}

/// Where it has an effect it says how it bends light and what it cannot follow.
TEST_F(RefractionInTheWindow, ThatHasNoEffect_SaysWhy) {
    auto* hint = panel()->findChild<QLabel*>("hint");
    ASSERT_NE(hint, nullptr);
    choose("solid-body");
    EXPECT_EQ(hint->text(), "The material's opacity is 1: nothing passes.");
    document().setValue(document().selection().currentPath(settings::material), "opacity", 0.2);
    EXPECT_TRUE(hint->text().contains("Exact for bodies without dents"));
    choose("");
    EXPECT_EQ(hint->text(), "");
}

TEST_F(RefractionInTheWindow, DraggedToIndexOneAndBack_CompilesNothing) {
    view().setFixedSize(160, 120);
    choose("solid-body");
    document().setValue(document().selection().currentPath(settings::material), "opacity", 0.2);
    const BlockPath path = document().selection().currentPath(kinds::refraction);
    document().setValue(path, "index.from", std::string("own"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().frames().isUpToDate(); }, limitMs));
    int compiled = 0;
    QObject::connect(&view().frames(), &FrameLoop::frameDrawn, &view(),
                     [&] { compiled += view().frames().report().compiled; });
    const int token = document().interaction().begin(ParameterTarget{path, "index"});
    for (const double index : {1.8, 1.0, 2.5, 1.2}) {
        const int frames = view().frames().frameCount();
        document().setValue(path, "index", index);
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return view().frames().frameCount() > frames; }, limitMs));
    }
    EXPECT_EQ(compiled, 0);
    document().interaction().end(token);
}

} // namespace
} // namespace patina::tests::refraction_test
