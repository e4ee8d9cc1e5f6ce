// SPDX-License-Identifier: GPL-3.0-or-later
// A and B shown as one picture: wiped, flipped, as an onion skin and blinking.
#include <algorithm>

#include <QAction>
#include <QComboBox>
#include <QMenu>
#include <QSlider>
#include <QTest>

#include "session/session.h"
#include "ui/window_fixture.h"
#include "viewport/composed_view.h"
#include "viewport/difference_view.h"
#include "viewport/view_links.h"

namespace patina::tests::compare_modes_test {
namespace {

constexpr int waitMs = 20000;

class CompareModes : public WindowFixture {
  protected:
    /// A and B, which differ, shown in this mode.
    void compareAs(CompareMode mode) {
        window().comparison().setComparing(true);
        window().files().applyPreset(QString::fromStdString(otherPreset(document()).string()),
                                     Side::B);
        setMode(mode);
        ASSERT_NO_FATAL_FAILURE(waitForPictures());
    }

    void setMode(CompareMode mode) {
        CompareLook look = window().views().look();
        look.mode = mode;
        window().views().setLook(look);
    }

    void waitForPictures() {
        settle();
        ASSERT_TRUE(QTest::qWaitFor(
            [this] {
                return view().frames().isUpToDate() && secondView().frames().isUpToDate() &&
                       !composed().picture().isNull() && composed().isUpToDate();
            },
            waitMs));
    }

    ComposedView& composed() { return *window().views().composed(); }
    QImage ofA() { return view().grabPicture().convertToFormat(QImage::Format_RGB32); }
    QImage ofB() { return secondView().grabPicture().convertToFormat(QImage::Format_RGB32); }

    void dragOver(const QPoint& from, const QPoint& to) {
        QTest::mousePress(&composed(), Qt::LeftButton, {}, from);
        QMouseEvent move(QEvent::MouseMove, to, composed().mapToGlobal(to), Qt::NoButton,
                         Qt::LeftButton, {});
        QApplication::sendEvent(&composed(), &move);
        QTest::mouseRelease(&composed(), Qt::LeftButton, {}, to);
    }

    WipeLine line() {
        const CompareLook& look = window().views().look();
        return {QSizeF(composed().size()), look.wipe, look.wipeAngle};
    }
};

TEST_F(CompareModes, Wipe_HasALeftAndBRightOfTheLine) {
    compareAs(CompareMode::Wipe);
    ASSERT_EQ(view().size(), secondView().size());
    const QImage shown = composed().picture();
    const int half = shown.width() / 2;
    EXPECT_NE(ofA(), ofB());
    EXPECT_EQ(shown.copy(0, 0, half, shown.height()), ofA().copy(0, 0, half, shown.height()));
    EXPECT_EQ(shown.copy(half + 1, 0, half - 1, shown.height()),
              ofB().copy(half + 1, 0, half - 1, shown.height()));
}

TEST_F(CompareModes, LinksOfBothSides_AreReachedBelowTheirTitles) {
    compareAs(CompareMode::Wipe);
    const auto links = composed().findChildren<ViewLinks*>();
    ASSERT_EQ(links.size(), 2);
    for (ViewLinks* each : links) {
        EXPECT_TRUE(composed().rect().contains(each->geometry()));
        EXPECT_EQ(composed().childAt(each->geometry().center()), each);
    }
    EXPECT_LT(links[0]->geometry().right(), composed().width() / 2);
    EXPECT_GT(links[1]->geometry().left(), composed().width() / 2);
    links[1]->menu()->findChild<QAction*>("ownExposure")->trigger();
    EXPECT_TRUE(ownView(document().state(), Side::B).exposure.has_value());
    EXPECT_TRUE(composed().rect().contains(links[1]->geometry())) << links[1]->text().toStdString();
    CompareLook turned = window().views().look();
    turned.wipeAngle = 180.0;
    window().views().setLook(turned);
    EXPECT_GT(links[0]->geometry().left(), composed().width() / 2);
}

TEST_F(CompareModes, DraggedWipeLine_MovesAndDrawsNoFrame) {
    compareAs(CompareMode::Wipe);
    newFrames();
    const int framesOfB = secondView().frames().frameCount();
    const QPoint grip = line().grip().toPoint();
    dragOver(grip, grip - QPoint(composed().width() / 4, 0));
    settle();
    EXPECT_NEAR(window().views().look().wipe, 0.25, 0.01);
    EXPECT_EQ(newFrames(), 0);
    EXPECT_EQ(secondView().frames().frameCount(), framesOfB);
    const QPoint now(composed().width() / 3, 10);
    EXPECT_EQ(composed().picture().pixel(now), ofB().pixel(now));
}

TEST_F(CompareModes, DraggedKnob_TurnsTheLineAboutItsGrip) {
    compareAs(CompareMode::Wipe);
    const QPointF grip = line().grip();
    dragOver(line().knob().toPoint(), grip.toPoint() + QPoint(100, 0));
    EXPECT_NEAR(window().views().look().wipeAngle, 90.0, 1.0);
    EXPECT_NEAR(line().depthInB(grip), 0.0, 1.0);
}

TEST_F(CompareModes, DragBesideTheLine_TurnsTheCameraAndTakesTheSide) {
    compareAs(CompareMode::Wipe);
    const double yaw = camera().yaw;
    const QPoint inB(3 * composed().width() / 4, composed().height() / 2);
    dragOver(inB, inB + QPoint(30, 0));
    EXPECT_EQ(document().selection().side(), Side::B);
    EXPECT_NE(camera().yaw, yaw);
    EXPECT_EQ(secondView().camera(), camera());
}

TEST_F(CompareModes, HeldSpace_ShowsTheOtherSide) {
    compareAs(CompareMode::Flip);
    EXPECT_EQ(composed().picture(), ofA());
    QTest::keyPress(&view(), Qt::Key_Space);
    EXPECT_EQ(composed().picture(), ofB());
    QTest::keyRelease(&view(), Qt::Key_Space);
    EXPECT_EQ(composed().picture(), ofA());
}

TEST_F(CompareModes, Onion_IsBetweenThePictures) {
    compareAs(CompareMode::Onion);
    const QPoint middle = composed().rect().center();
    const int shown = qGreen(composed().picture().pixel(middle));
    const int half = (qGreen(ofA().pixel(middle)) + qGreen(ofB().pixel(middle))) / 2;
    EXPECT_NEAR(shown, half, 2);
    for (int i = 0; i < 10; ++i) {
        QTest::keyClick(&view(), ']');
    }
    EXPECT_EQ(composed().picture(), ofB());
}

TEST_F(CompareModes, Blink_ShowsBothInTurns) {
    compareAs(CompareMode::Blink);
    const auto shows = [this](const QImage& picture) {
        return QTest::qWaitFor([&] { return composed().picture() == picture; }, 3000);
    };
    EXPECT_TRUE(shows(ofB()));
    EXPECT_TRUE(shows(ofA()));
}

TEST_F(CompareModes, DifferenceAlone_FillsTheMiddle) {
    window().comparison().setComparing(true);
    setMode(CompareMode::Difference);
    settle();
    EXPECT_EQ(window().views().difference()->width(), window().views().width());
    setMode(CompareMode::SideBySide);
    EXPECT_TRUE(view().isVisible() && secondView().isVisible());
    EXPECT_FALSE(window().views().difference()->isVisible());
}

TEST_F(CompareModes, SideBySideAfterwards_IsAsBefore) {
    window().comparison().setComparing(true);
    settle();
    const QSize before = secondView().size();
    setMode(CompareMode::Wipe);
    settle();
    EXPECT_GT(view().width(), before.width());
    EXPECT_EQ(secondView().size(), view().size());
    setMode(CompareMode::SideBySide);
    settle();
    EXPECT_EQ(secondView().size(), before);
    EXPECT_EQ(view().height(), before.height());
}

TEST_F(CompareModes, ChosenInTheBar_AreThereAgainAfterAStart) {
    window().comparison().setComparing(true);
    auto* modes = window().findChild<QComboBox*>("compareMode");
    modes->setFocus();
    QTest::keyClicks(modes, "Onion");
    ASSERT_EQ(window().views().look().mode, CompareMode::Onion);
    window().findChild<QSlider*>("compareAmount")->setValue(50);
    EXPECT_NEAR(window().views().look().onion, 0.25, 1e-9);
    const CompareLook chosen = window().views().look();
    close();
    open();
    EXPECT_EQ(window().views().look(), chosen);
}

TEST_F(CompareModes, KeyC_GoesThroughTheModes) {
    window().comparison().setComparing(true);
    const auto actions = window().findChildren<QAction*>();
    const auto next = std::ranges::find(actions, QKeySequence("C"), &QAction::shortcut);
    ASSERT_NE(next, actions.end());
    (*next)->trigger();
    EXPECT_EQ(window().views().look().mode, CompareMode::Wipe);
    (*next)->trigger();
    EXPECT_EQ(window().views().look().mode, CompareMode::Flip);
}

} // namespace
} // namespace patina::tests::compare_modes_test
