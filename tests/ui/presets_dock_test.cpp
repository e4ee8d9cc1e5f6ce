// SPDX-License-Identifier: GPL-3.0-or-later

#include <QDockWidget>
#include <QTest>

#include "docks/picture_grid.h"
#include "docks/search_box.h"
#include "ui/window_fixture.h"

namespace patina::tests::presets_dock_test {
namespace {

class PresetSearch : public WindowFixture {
  protected:
    void SetUp() override {
        window().startRest();
        ASSERT_TRUE(QTest::qWaitFor([this] { return grid().count() > 0; }, 20000));
        grid().setCurrentRow(0);
    }

    PictureGrid& grid() { return *window().dock("presets")->findChild<PictureGrid*>(); }
    SearchBox& search() { return *window().dock("presets")->findChild<SearchBox*>(); }

    /// The first preset that the search shows.
    QListWidgetItem& firstHit() { return *grid().firstShown(); }

    QString nameOnA() { return QString::fromStdString(document().material(Side::A)->name); }
};

TEST_F(PresetSearch, Enter_PutsAHitThatIsShownOnTheSide) {
    const QString hidden = grid().currentItem()->text();
    QTest::keyClicks(&search(), "gold");
    ASSERT_TRUE(grid().item(0)->isHidden());
    QTest::keyClick(&search(), Qt::Key_Return);
    EXPECT_EQ(nameOnA(), firstHit().text());
    EXPECT_NE(nameOnA(), hidden);
}

TEST_F(PresetSearch, EnterWithoutAHit_ChangesNothing) {
    QTest::keyClicks(&search(), "no such preset");
    QTest::keyClick(&search(), Qt::Key_Return);
    EXPECT_EQ(document().undoStack().count(), 0);
}

TEST_F(PresetSearch, ClickOnTheCurrentHit_PutsItOnTheSide) {
    QTest::keyClicks(&search(), "gold");
    grid().setCurrentItem(&firstHit());
    const QPoint place = grid().visualItemRect(&firstHit()).topLeft() + QPoint(30, 10);
    QTest::mouseClick(grid().viewport(), Qt::LeftButton, {}, place);
    EXPECT_EQ(nameOnA(), firstHit().text());
}

TEST_F(PresetSearch, DoubleClick_IsOneStep) {
    const QPoint place = grid().visualItemRect(&firstHit()).topLeft() + QPoint(30, 10);
    QTest::mouseClick(grid().viewport(), Qt::LeftButton, {}, place);
    QTest::mouseDClick(grid().viewport(), Qt::LeftButton, {}, place);
    EXPECT_EQ(document().undoStack().count(), 1);
}

} // namespace
} // namespace patina::tests::presets_dock_test
