// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QScrollBar>
#include <QTest>

#include "docks/picture_grid.h"

namespace patina::tests {
namespace {

std::vector<PictureGrid::Entry> entries(int count) {
    std::vector<PictureGrid::Entry> entries;
    for (int i = 0; i < count; ++i) {
        entries.push_back({QString::number(i), QString::number(i), {}, {}});
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

} // namespace
} // namespace patina::tests
