// SPDX-License-Identifier: GPL-3.0-or-later
#include "schema_check.h"
#include "sheet/sheet_file.h"

#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "support/program.h"

namespace patina::sheet_file_test {
namespace {

using nlohmann::json;

class SheetFile : public testing::Test {
  protected:
    Checked<SheetReading> read(const std::string& text) {
        tests::writeFile(file_, text);
        return readSheet(file_);
    }

    std::string mistakes(const std::string& text) {
        const auto reading = read(text);
        return reading ? std::string() : patina::text(reading.error());
    }

    tests::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "a.patina-sheet.json";
};

Sheet everyKey() {
    Sheet sheet;
    sheet.name = "All";
    sheet.x = {AxisKind::Value, "gloss", SheetRange{0.25, 0.75, 3}, {}};
    sheet.y = SheetAxis{AxisKind::Value, "tint", {}, {"0.5", "true", "1,0,0", "twill"}};
    sheet.hasControlRow = false;
    sheet.cellPixels = 64;
    sheet.numbers = {CellNumber::Error, CellNumber::Time};
    sheet.unknown["later"] = 5;
    return sheet;
}

TEST_F(SheetFile, Written_ReadsBackAsTheSame) {
    Sheet sheet = everyKey();
    sheet.preset = (folder_ / "b.patina.json").generic_string();
    ASSERT_TRUE(writeSheet(file_, sheet));
    const auto reading = readSheet(file_);
    ASSERT_TRUE(reading) << text(reading.error());
    EXPECT_EQ(reading->sheet, sheet);
    EXPECT_EQ(text(reading->notes), "");
}

TEST_F(SheetFile, EveryKindOfAxis_ReadsBack) {
    for (const AxisKind kind :
         {AxisKind::Models, AxisKind::Environments, AxisKind::Lights, AxisKind::Accuracy}) {
        Sheet sheet = everyKey();
        sheet.x = {kind, {}, {}, {"one", "two"}};
        ASSERT_TRUE(writeSheet(file_, sheet));
        const auto reading = readSheet(file_);
        ASSERT_TRUE(reading) << text(reading.error());
        EXPECT_EQ(reading->sheet.x, sheet.x);
    }
}

TEST_F(SheetFile, Mistakes_HaveLineAndColumn) {
    const std::string told = mistakes(R"({
  "format": "patina.sheet",
  "version": 1,
  "x": {"value": "gloss", "from": 0, "to": "one", "steps": 4},
  "y": {"models": ["chalk", 7]},
  "numbers": ["albedo", "weight"]
})");
    EXPECT_NE(told.find(":4:44: the text \"one\" stands at \"to\""), std::string::npos) << told;
    EXPECT_NE(told.find(":5:29: the number 7 stands here"), std::string::npos) << told;
    EXPECT_NE(told.find(":6:25: the text \"weight\" stands here; expected time, error or albedo"),
              std::string::npos)
        << told;
}

TEST_F(SheetFile, MisspeltKeyOfAnAxis_IsAMistake) {
    const std::string told =
        mistakes(R"({"format": "patina.sheet", "version": 1, "x": {"value": "gloss", "step": 4}})");
    EXPECT_NE(told.find("an axis has no key \"step\"; expected 'steps'"), std::string::npos)
        << told;
}

TEST_F(SheetFile, WithoutAnAxis_IsAMistake) {
    EXPECT_NE(mistakes(R"({"format": "patina.sheet", "version": 1})").find("\"x\" is missing"),
              std::string::npos);
    EXPECT_NE(mistakes(R"({"format": "patina.sheet", "version": 1, "x": {}})")
                  .find("does not say what it is of"),
              std::string::npos);
}

TEST_F(SheetFile, Limits_AreToldAtTheirPlace) {
    const std::string told =
        mistakes("{\"format\": \"patina.sheet\", \"version\": 1,\n\"cellPixels\": 5,\n"
                 "\"x\": {\"value\": \"a\", \"from\": 0, \"to\": 1, \"steps\": 99}}");
    EXPECT_NE(told.find(":2:15: cells of 5 pixels; expected 16 .. 1024"), std::string::npos)
        << told;
    EXPECT_NE(told.find(":3:50: 99 steps; expected 1 .. 32"), std::string::npos) << told;
}

TEST_F(SheetFile, PresetOfAStranger_IsNotRead) {
    const auto reading = read(R"({"format": "patina.sheet", "version": 1,
        "preset": "../../etc/passwd", "x": {"models": []}})");
    ASSERT_TRUE(reading) << text(reading.error());
    EXPECT_EQ(reading->sheet.preset, "");
    EXPECT_EQ(reading->outside.size(), 1u);
    EXPECT_EQ(reading->notes.size(), 1u);
}

TEST_F(SheetFile, Environment_IsNeverAFile) {
    EXPECT_NE(mistakes(R"({"format": "patina.sheet", "version": 1,
        "x": {"environments": ["none", "/home/me/sky.hdr"]}})")
                  .find("a sheet names no files"),
              std::string::npos);
}

TEST(ShippedSheets, AreAsTheSchemaHasThem) {
    int sheets = 0;
    for (const auto& entry : std::filesystem::directory_iterator(dataFolder() / "presets/sheets")) {
        const auto document = readJson(entry.path());
        ASSERT_TRUE(document);
        EXPECT_EQ(text(checkSchema(*document, "sheet")), "");
        const auto reading = readSheet(entry.path());
        ASSERT_TRUE(reading) << text(reading.error());
        EXPECT_EQ(text(reading->notes), "");
        EXPECT_TRUE(std::filesystem::exists(reading->sheet.preset));
        ++sheets;
    }
    EXPECT_GE(sheets, 1);
}

} // namespace
} // namespace patina::sheet_file_test
