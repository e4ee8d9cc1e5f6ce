// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QScrollBar>
#include <QTest>

#include "docks/picture_grid.h"

namespace patina::tests::picture_grid_test {
namespace {

std::vector<PictureGrid::Entry> entries(int count) {
    std::vector<PictureGrid::Entry> entries;
    for (int i = 0; i < count; ++i) {
        entries.push_back({QString::number(i), QString::number(i), {}});
    }
    return entries;
}

TEST(Grid, ClickBesideTheItems_KeepsTheChoice) {
    PictureGrid grid(72);
    grid.resize(300, 300);
    grid.setEntries(entries(2));
    grid.setCurrentRow(1);
    grid.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&grid));
    const QPoint beside(20, 280);
    ASSERT_EQ(grid.itemAt(beside), nullptr);
    QTest::mouseClick(grid.viewport(), Qt::LeftButton, {}, beside);
    ASSERT_EQ(grid.selectedItems().size(), 1);
    EXPECT_EQ(grid.selectedItems().front(), grid.item(1));
}

TEST(Grid, EnterOnAHiddenItem_ChoosesNothing) {
    PictureGrid grid(72);
    grid.setEntries(entries(2));
    grid.setCurrentRow(0);
    std::vector<QString> chosen;
    QObject::connect(&grid, &PictureGrid::chosen, &grid,
                     [&](QListWidgetItem* item) { chosen.push_back(item->text()); });
    grid.item(0)->setHidden(true);
    QTest::keyClick(&grid, Qt::Key_Return);
    EXPECT_TRUE(chosen.empty());
    grid.item(0)->setHidden(false);
    QTest::keyClick(&grid, Qt::Key_Return);
    EXPECT_EQ(chosen, std::vector<QString>{"0"});
}

TEST(Grid, NewEntries_KeepThePlace) {
    PictureGrid grid(72);
    grid.resize(300, 300);
    grid.setEntries(entries(60));
    grid.setCurrentRow(0);
    grid.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&grid));
    grid.verticalScrollBar()->setValue(500);
    ASSERT_EQ(grid.verticalScrollBar()->value(), 500);
    grid.setEntries(entries(61));
    QTest::qWait(50); // a layout that was put off
    EXPECT_EQ(grid.verticalScrollBar()->value(), 500);
}

TEST(Grid, ChosenItem_IsInSightWhenTheGridIsFirstShownAndResized) {
    PictureGrid grid(72);
    grid.setEntries(entries(60));
    grid.setCurrentRow(40);
    grid.scrollToItem(grid.item(40));
    const auto isInSight = [&grid] {
        QTest::qWait(50); // a layout that was put off
        return grid.viewport()->rect().contains(grid.visualItemRect(grid.item(40)).center());
    };
    grid.resize(300, 300);
    grid.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&grid));
    EXPECT_TRUE(isInSight());
    grid.resize(140, 260);
    EXPECT_TRUE(isInSight());
}

TEST(Grid, NullPicture_TakesTheOneThatIsThereAway) {
    PictureGrid grid(72);
    grid.setEntries(entries(1));
    const QImage empty = grid.item(0)->icon().pixmap(72).toImage();
    QImage picture(72, 72, QImage::Format_RGB888);
    picture.fill(Qt::red);
    grid.setPicture("0", picture);
    ASSERT_NE(grid.item(0)->icon().pixmap(72).toImage(), empty);
    grid.setPicture("0", QImage());
    EXPECT_EQ(grid.item(0)->icon().pixmap(72).toImage(), empty);
    grid.setEntries(entries(1));
    EXPECT_EQ(grid.item(0)->icon().pixmap(72).toImage(), empty);
}

/// A shown grid of 60 items, and the keys of those whose picture it wished for.
struct WatchedGrid {
    WatchedGrid() {
        QObject::connect(&grid, &PictureGrid::pictureWished, &grid,
                         [this](const QString& key) { wished << key; });
        grid.resize(300, 300);
        grid.setEntries(entries(60));
        grid.show();
    }

    PictureGrid grid{72};
    QStringList wished;
};

TEST(Grid, ItemsOutOfSight_GetNoPicture) {
    WatchedGrid watched;
    ASSERT_TRUE(QTest::qWaitFor([&] { return watched.wished.contains("0"); }));
    EXPECT_FALSE(watched.wished.contains("59"));
}

TEST(Grid, ItemThatIsScrolledTo_GetsItsPictureOnce) {
    WatchedGrid watched;
    ASSERT_TRUE(QTest::qWaitFor([&] { return watched.wished.contains("0"); }));
    watched.grid.scrollToBottom();
    ASSERT_TRUE(QTest::qWaitFor([&] { return watched.wished.contains("59"); }));
    watched.grid.viewport()->repaint();
    EXPECT_EQ(watched.wished.count("59"), 1);
}

TEST(Grid, PicturesOfSomethingThatChanged_AreWishedAnew) {
    WatchedGrid watched;
    ASSERT_TRUE(QTest::qWaitFor([&] { return watched.wished.contains("0"); }));
    watched.grid.wishAnew();
    EXPECT_TRUE(QTest::qWaitFor([&] { return watched.wished.count("0") == 2; }));
}

} // namespace
} // namespace patina::tests::picture_grid_test
