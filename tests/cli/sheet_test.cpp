// SPDX-License-Identifier: GPL-3.0-or-later
// Contact sheets from the command line.
#include <algorithm>

#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::sheet_test {
namespace {

const std::string plastic = shipped("presets/strauss/red-plastic.patina.json").string();
const std::string strauss = shipped("presets/sheets/strauss.patina-sheet.json").string();

/// Small cells without an environment: what is tested is not the picture.
Outcome sheet(std::vector<std::string> more, const std::string& source = plastic) {
    more.insert(more.begin(), {"sheet", source, "--cell", "16", "--environment", "none"});
    return patina(std::move(more));
}

std::size_t lines(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

TEST(SheetCommand, TwoAxes_WriteAPicture) {
    const Outcome outcome =
        sheet({"--x", "metalness=0:1:3", "--y", "smoothness=0.2,0.8", "-o", "-"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("\x89PNG"));
}

TEST(SheetCommand, Exr_IsWritten) {
    const TemporaryFolder folder;
    const Outcome outcome = sheet({"--x", "metalness=0:1:2", "-o", (folder / "a.exr").string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(readFile(folder / "a.exr").starts_with("\x76\x2f\x31\x01"));
}

TEST(SheetCommand, Table_HasEveryCellWithItsNumbers) {
    const TemporaryFolder folder;
    const Outcome outcome = sheet({"--x", "metalness=0,1", "--y", "power=exact,rational",
                                   "--numbers", "albedo,error", "-o", (folder / "a.csv").string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const std::string csv = readFile(folder / "a.csv");
    EXPECT_TRUE(csv.starts_with("column,row,Metalness,")) << csv;
    EXPECT_EQ(lines(csv), 1u + 2u * 3u) << csv;
    EXPECT_NE(csv.find("\n1,1,0,exact,,"), std::string::npos) << csv;
    EXPECT_NE(csv.find("\n2,3,start,start,,"), std::string::npos) << csv;
    EXPECT_EQ(csv.find(",,,"), std::string::npos) << csv; // each has both numbers
}

TEST(SheetCommand, ModelWithoutTheValue_IsACellThatSaysSo) {
    const TemporaryFolder folder;
    const Outcome outcome =
        sheet({"--x", "metalness=0,1", "--y", "models=strauss,lambert", "--no-control", "--numbers",
               "albedo", "-o", (folder / "a.csv").string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const std::string csv = readFile(folder / "a.csv");
    EXPECT_EQ(lines(csv), 1u + 2u * 2u) << csv;
    EXPECT_NE(csv.find("has no such parameter"), std::string::npos) << csv;
}

TEST(SheetCommand, SheetsFile_IsDrawnFromItsPreset) {
    const Outcome outcome = sheet({"-o", "-"}, strauss);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("\x89PNG"));
}

TEST(SheetCommand, EachMistake_IsToldWithWhatWouldBeRight) {
    const auto told = [](const std::vector<std::string>& more) {
        const Outcome outcome = sheet(more);
        EXPECT_EQ(outcome.exitCode, 1) << outcome.out;
        return outcome.err;
    };
    EXPECT_NE(told({"-o", "-"}).find("the sheet has no axis"), std::string::npos);
    EXPECT_NE(told({"--x", "metalnes=0:1:2", "-o", "-"}).find("'metalness'"), std::string::npos);
    EXPECT_NE(told({"--x", "metalness=0:2:2", "-o", "-"}).find("x: metalness: \"2\""),
              std::string::npos);
    EXPECT_NE(told({"--x", "metalness=0:1:99", "-o", "-"}).find("1 .. 32"), std::string::npos);
    EXPECT_NE(told({"--x", "metalness=", "-o", "-"}).find("--x"), std::string::npos);
    EXPECT_NE(told({"--x", "metalness=0:1:2", "--numbers", "weight", "-o", "-"})
                  .find("time, error or albedo"),
              std::string::npos);
    EXPECT_NE(told({"--x", "metalness=0:1:2", "-o", "a.txt"}).find("a.txt"), std::string::npos);
}

} // namespace
} // namespace patina::tests::sheet_test
