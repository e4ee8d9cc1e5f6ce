// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::german_locale_test {
namespace {

const std::map<std::string, std::string> german = {{"LC_ALL", "de_DE.UTF-8"},
                                                   {"LOCPATH", localeFolder()}};

Outcome inGerman(std::vector<std::string> arguments, std::string input = {}) {
    return patina(
        Start{.arguments = std::move(arguments), .environment = german, .input = std::move(input)});
}

TEST(GermanLocale, OfTheTests_WritesADecimalComma) {
    const Outcome outcome = run(
        "/usr/bin/printf", Start{.arguments = {"%.1f", "1"}, .environment = german, .input = {}});
    EXPECT_EQ(outcome.out, "1,0") << "the other tests in this file would prove nothing";
}

TEST(GermanLocale, Render_GivesTheSamePicture) {
    const std::vector<std::string> command = {
        "render", "--model", "phong", "--set", "shininess=12.5", "--size", "64x64", "-o", "-"};
    const Outcome plain = patina(command);
    ASSERT_EQ(plain.exitCode, 0) << plain.err;
    EXPECT_TRUE(inGerman(command).out == plain.out);
}

TEST(GermanLocale, Eval_GivesTheSameNumbers) {
    const std::string input = R"({"id": "a", "model": "phong", "l": [0.6, 0, 0.8],)"
                              R"( "v": [-0.5, 0.1, 0.9], "precision": "double"})"
                              "\n";
    const Outcome plain = patina(Start{.arguments = {"eval"}, .environment = {}, .input = input});
    ASSERT_EQ(plain.exitCode, 0) << plain.err;
    EXPECT_EQ(inGerman({"eval"}, input).out, plain.out);
}

TEST(GermanLocale, Validate_AcceptsTheShippedPresets) {
    const Outcome outcome =
        inGerman({"validate", shipped("presets/cook-torrance/gold.patina.json").string()});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
}

TEST(GermanLocale, Set_WantsAPoint) {
    const Outcome outcome = inGerman(
        {"render", "--model", "phong", "--set", "shininess=12,5", "--size", "16x16", "-o", "-"});
    EXPECT_EQ(outcome.exitCode, 1);
}

} // namespace
} // namespace patina::tests::german_locale_test
