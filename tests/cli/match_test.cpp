// SPDX-License-Identifier: GPL-3.0-or-later
// `patina match` finds values, says which model is nearest, and writes it as a preset.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"

namespace patina::match_test {
namespace {

using tests::Outcome;
using tests::patina;
using tests::readFile;
using tests::TemporaryFolder;
using tests::writeFile;

std::string preset(const std::string& name) {
    return PATINA_SOURCE_DIR "/presets/" + name;
}

TEST(Match, ShippedPreset_IsFoundByItsOwnModelAndWritten) {
    const TemporaryFolder folder;
    const std::string best = folder / "best.patina.json";
    const Outcome outcome =
        patina({"match", "--to", preset("cook-torrance/gold.patina.json"), "--model", "lambert",
                "--model", "cook-torrance", "--samples", "256", "--json", "-o", best});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto rows = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0]["model"], "cook-torrance");
    EXPECT_LT(rows[0]["relative"], 1e-4);
    EXPECT_GT(rows[1]["relative"], 0.1);
    EXPECT_EQ(patina({"validate", best}).exitCode, 0);
    EXPECT_EQ(nlohmann::json::parse(readFile(best))["model"]["id"], "cook-torrance");
}

TEST(Match, NothingToFit_SaysWhatIsExpected) {
    const Outcome outcome = patina({"match", "--to", preset("cook-torrance/gold.patina.json")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("--all-models"), std::string::npos) << outcome.err;
}

TEST(Match, WrongModelOrFile_SaysSo) {
    EXPECT_NE(patina({"match", "--to", preset("cook-torrance/gold.patina.json"), "--model",
                      "cook-torrence"})
                  .err.find("cook-torrance"),
              std::string::npos);
    const TemporaryFolder folder;
    writeFile(folder / "text.binary", "this is no measured surface at all");
    const Outcome outcome = patina({"match", "--to", folder / "text.binary", "--model", "lambert"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("text.binary: byte 0"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace patina::match_test
