// SPDX-License-Identifier: GPL-3.0-or-later
// Passes over the picture in the real window.
#include <QDockWidget>
#include <QTest>
#include <QToolButton>

#include "docks/passes_panel.h"
#include "document/scene_edits.h"
#include "ui/window_fixture.h"

namespace patina::tests::picture_passes_test {
namespace {

class PicturePasses : public WindowFixture {
  protected:
    PicturePasses() {
        addPass(document(), "kuwahara");
        newFrames();
    }

    /// Sets the value of the first pass as a slider does.
    void set(const std::string& id, double value) {
        document().setValue(pathOf(kinds::pass), id, value);
    }

    int restyled() { return view().frames().restyledCount(); }
};

TEST_F(PicturePasses, SlidersTick_DrawsThePassAlone) {
    const QImage before = view().grabPicture();
    const int already = restyled();
    set("radius", 20.0);
    EXPECT_EQ(newFrames(), 0);
    EXPECT_EQ(restyled(), already + 1);
    const QImage restyledPicture = view().grabPicture();
    EXPECT_NE(restyledPicture, before);
    view().frames().refresh();
    EXPECT_EQ(newFrames(), 1);
    EXPECT_EQ(view().grabPicture(), restyledPicture);
}

/// The view frees what it draws into once it rests, but not the picture under a pass.
TEST_F(PicturePasses, SlidersTickAfterARest_DrawsThePassAlone) {
    constexpr int restMs = 1000;
    QTest::qWait(restMs);
    const int already = restyled();
    set("radius", 20.0);
    EXPECT_EQ(newFrames(), 0);
    EXPECT_EQ(restyled(), already + 1);
}

TEST_F(PicturePasses, RemovedPass_LeavesThePictureWithoutIt) {
    document().undoStack().undo();
    newFrames();
    const QImage without = view().grabPicture();
    addPass(document(), "kuwahara");
    newFrames();
    EXPECT_NE(view().grabPicture(), without);
    removePass(document(), 0);
    newFrames();
    EXPECT_EQ(view().grabPicture(), without);
}

TEST_F(PicturePasses, PanelsButtons_MoveAndRemovePasses) {
    window().dock("scene")->show();
    window().dock("scene")->raise();
    addPass(document(), "kuwahara");
    document().setValue(pathOf(kinds::pass), "radius", 3.0);
    settle();
    auto* panel = window().dock("scene")->findChild<PassesPanel*>();
    ASSERT_NE(panel, nullptr);
    const auto press = [&](const QString& text, int which) {
        QList<QToolButton*> fitting;
        for (auto* button : panel->findChildren<QToolButton*>()) {
            if (button->text() == text && button->isVisibleTo(panel)) {
                fitting.push_back(button);
            }
        }
        ASSERT_GT(fitting.size(), which);
        fitting[which]->click();
        settle();
    };
    press("Down", 0);
    EXPECT_EQ(document().scene().passes.at(1).parameters.at("radius"), Value(3.0));
    press("Remove", 0);
    ASSERT_EQ(document().scene().passes.size(), 1u);
    EXPECT_EQ(document().scene().passes[0].parameters.at("radius"), Value(3.0));
}

} // namespace
} // namespace patina::tests::picture_passes_test
