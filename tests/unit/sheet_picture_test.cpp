// SPDX-License-Identifier: GPL-3.0-or-later
// The picture and the table of a contact sheet.
#include "sheet/sheet_picture.h"

#include <gtest/gtest.h>

#include "sheet/sheet_table.h"
#include "sheet_fixture.h"

namespace patina::sheet_picture_test {
namespace {

constexpr int cell = 32;

SheetPlan twoByThree() {
    Sheet sheet;
    sheet.x = {AxisKind::Value, "gloss", SheetRange{0.0, 1.0, 2}, {}};
    sheet.y = SheetAxis{AxisKind::Value, "tint", {}, {"1,0,0", "0,1,0"}};
    return SheetPlan::of(sheet, tests::sheetScene(), 0, tests::sheetCatalog()).value();
}

Image plain(float level) {
    return {cell, cell, 4, std::vector<float>(std::size_t(cell) * cell * 4, level)};
}

float at(const Image& image, glm::ivec2 place) {
    return image
        .pixels[(std::size_t(place.y) * std::size_t(image.width) + std::size_t(place.x)) * 3];
}

TEST(SheetPicture, Cells_KeepTheirPixelsAndNeverOverlap) {
    const SheetPlan plan = twoByThree();
    SheetPicture picture(plan, "Name", {cell, 1, true});
    float level = 0.0f;
    for (int row = 0; row < plan.rows(); ++row) {
        for (int column = 0; column < plan.columns(); ++column) {
            picture.put(column, row, plain(level += 0.1f), {"error 0.001"});
        }
    }
    level = 0.0f;
    for (int row = 0; row < plan.rows(); ++row) {
        for (int column = 0; column < plan.columns(); ++column) {
            level += 0.1f;
            const glm::ivec2 corner = picture.corner(column, row);
            EXPECT_EQ(at(picture.image(), corner), level);
            EXPECT_EQ(at(picture.image(), corner + cell - 1), level);
        }
    }
}

TEST(SheetPicture, ControlRow_StandsApart) {
    const SheetPlan plan = twoByThree();
    const SheetPicture picture(plan, {}, {cell, 0, true});
    const int between = picture.corner(0, 1).y - picture.corner(0, 0).y;
    EXPECT_GT(picture.corner(0, 2).y - picture.corner(0, 1).y, between);
    EXPECT_GE(picture.image().height, picture.corner(0, 2).y + cell);
}

TEST(SheetPicture, Labels_AreDrawnBesideTheCells) {
    const SheetPlan plan = twoByThree();
    const SheetPicture picture(plan, "Name", {cell, 0, true});
    const Image& image = picture.image();
    const int top = picture.corner(0, 0).y;
    const auto end = image.pixels.begin() + std::ptrdiff_t(top) * image.width * 3;
    EXPECT_GT(std::count(image.pixels.begin(), end, 1.0f), 100);
}

TEST(SheetTable, EveryCell_IsALineWithItsAxesAndNumbers) {
    const SheetPlan plan = twoByThree();
    const std::string csv = sheetCsv(
        plan, {{0, 0, {1.5, 0.25, 0.5}, {}}, {1, 1, {}, "it has no \"sheen\""}, {1, 2, {}, {}}});
    EXPECT_EQ(csv, "column,row,Gloss,Tint,milliseconds,error,albedo,problem\n"
                   "1,1,0,\"1,0,0\",1.5,0.25,0.5,\n"
                   "2,2,1,\"0,1,0\",,,,\"it has no \"\"sheen\"\"\"\n"
                   "2,3,start,start,,,,\n");
}

TEST(SheetTable, Caption_IsALineForEachNumberThatIsWanted) {
    EXPECT_EQ(captionOf({1.234, 0.00123, {}}, {CellNumber::Error, CellNumber::Albedo}),
              (std::vector<std::string>{"error 0.0012", ""}));
}

} // namespace
} // namespace patina::sheet_picture_test
