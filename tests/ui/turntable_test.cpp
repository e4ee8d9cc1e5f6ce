// SPDX-License-Identifier: GPL-3.0-or-later
// A turntable turns what is seen and nothing else.
#include <QAction>
#include <QFile>
#include <QSignalSpy>
#include <QTest>

#include "background/long_tasks.h"
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
    const QImage before = view().grabPicture();
    const DocumentState state = document().state();
    const int frames = view().frames().frameCount();
    trigger("Turn the &Objects");
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().frames().frameCount() >= frames + 3; }, 20000));
    EXPECT_NE(view().grabPicture(), before);
    EXPECT_EQ(document().state(), state);
    EXPECT_EQ(document().undoStack().count(), 1);
    trigger("Turn the &Objects");
    newFrames();
    EXPECT_EQ(view().grabPicture(), before);
    QTest::qWait(200);
    EXPECT_EQ(newFrames(), 0);
}

TEST_F(TurntableView, OfAnEnvironmentThatIsNotThere_SaysSo) {
    const int before = window().messages().count();
    trigger("Turn the &Environment");
    EXPECT_FALSE(window().views().turntable().turning());
    EXPECT_GT(window().messages().count(), before);
}

/// A series of pictures of the first view.
class TurntableSeries : public WindowFixture {
  protected:
    TurntableExport::Source source() {
        return {
            [this](bool display, PictureCapture::SceneChange change, PictureCapture::Taken taken) {
                ++asked_;
                view().capture().start(display, std::move(taken), std::move(change));
            },
            [this] { view().capture().cancel(); }};
    }
    QString file(const char* name) { return QString::fromStdString(home(name).string()); }

    int asked_ = 0;
};

TEST_F(TurntableSeries, OfObjects_IsAWholeTurnInNumberedFilesAndNoEdit) {
    Object cube = document().scene().objects[0];
    cube.mesh = "builtin:cube";
    setObject(document(), 0, cube);
    newFrames();
    const QImage shown = view().grabPicture().convertToFormat(QImage::Format_RGB888);
    const DocumentState state = document().state();
    QSignalSpy saved(&window().turntables(), &TurntableExport::saved);
    window().turntables().start({TurntableOf::Object, 3, file("turn.png")}, source());
    EXPECT_EQ(LongTasks::all().running().back().name, "Writing a turntable");
    ASSERT_TRUE(saved.wait(20000));
    const QImage first = QImage(file("turn.0001.png")).convertToFormat(QImage::Format_RGB888);
    ASSERT_EQ(first.size(), shown.size());
    int largest = 0; // a turn by nothing may round
    for (int y = 0; y < shown.height(); ++y) {
        for (int i = 0; i < 3 * shown.width(); ++i) {
            largest =
                std::max(largest, std::abs(first.constScanLine(y)[i] - shown.constScanLine(y)[i]));
        }
    }
    EXPECT_LE(largest, 1);
    EXPECT_NE(QImage(file("turn.0002.png")), QImage(file("turn.0003.png")));
    EXPECT_FALSE(QFile::exists(file("turn.0004.png")));
    EXPECT_EQ(document().state(), state);
    newFrames();
    EXPECT_EQ(view().grabPicture().convertToFormat(QImage::Format_RGB888), shown);
}

TEST_F(TurntableSeries, Cancelled_DrawsNoMore) {
    window().turntables().start({TurntableOf::Object, 3600, file("turn.png")}, source());
    ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(file("turn.0001.png")); }, 20000));
    LongTasks::all().cancel(LongTasks::all().running().back().number);
    const int asked = asked_;
    settle();
    EXPECT_EQ(asked_, asked);
}

TEST_F(TurntableSeries, OfAnEnvironmentThatIsNotThere_SaysSo) {
    QSignalSpy failed(&window().turntables(), &TurntableExport::failed);
    window().turntables().start({TurntableOf::Environment, 2, file("turn.png")}, source());
    EXPECT_EQ(failed.count(), 1);
    EXPECT_EQ(asked_, 0);
}

} // namespace
} // namespace patina::tests::turntable_test
