// SPDX-License-Identifier: GPL-3.0-or-later
// A turntable turns what is seen and nothing else.
#include <QAction>
#include <QTest>

#include "document/scene_edits.h"
#include "ui/window_fixture.h"

namespace patina::tests::turntable_test {
namespace {

class TurntableView : public WindowFixture {
  protected:
    void trigger(const QString& text) {
        const auto actions = window().findChildren<QAction*>();
        const auto found = std::ranges::find(actions, text, &QAction::text);
        ASSERT_NE(found, actions.end());
        (*found)->trigger();
    }
};

TEST_F(TurntableView, OfObjects_TurnsThePictureAndNotTheDocument) {
    Object cube = document().scene().objects[0];
    cube.mesh = "builtin:cube";
    setObject(document(), 0, cube);
    newFrames();
    const QImage before = view().grabFramebuffer();
    const DocumentState state = document().state();
    const int frames = view().frames().frameCount();
    trigger("Turn the &Objects");
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().frames().frameCount() >= frames + 3; }, 20000));
    EXPECT_NE(view().grabFramebuffer(), before);
    EXPECT_EQ(document().state(), state);
    EXPECT_EQ(document().undoStack().count(), 1);
    trigger("Turn the &Objects");
    newFrames();
    EXPECT_EQ(view().grabFramebuffer(), before);
    QTest::qWait(200);
    EXPECT_EQ(newFrames(), 0);
}

TEST_F(TurntableView, OfAnEnvironmentThatIsNotThere_SaysSo) {
    const int before = window().messages().count();
    trigger("Turn the &Environment");
    EXPECT_FALSE(window().views().turntable().turning());
    EXPECT_GT(window().messages().count(), before);
}

} // namespace
} // namespace patina::tests::turntable_test
