// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <filesystem>

#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::shipped_presets_test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> shippedPresets() {
    std::vector<fs::path> presets;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(shipped("presets"))) {
        if (entry.path().string().ends_with(".patina.json")) {
            presets.push_back(entry.path());
        }
    }
    std::ranges::sort(presets);
    return presets;
}

/// "he_torrance_aluminium_rough" of presets/he-torrance/aluminium-rough.patina.json.
std::string nameOf(const testing::TestParamInfo<fs::path>& info) {
    std::string name =
        info.param.parent_path().filename().string() + '_' + info.param.stem().stem().string();
    std::ranges::replace_if(
        name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
    return name;
}

class ShippedPreset : public testing::TestWithParam<fs::path> {};

/// The whole sweep that a user gets: fewer cases miss combinations that break.
TEST_P(ShippedPreset, IsCheckedInItsEdgeCases_NothingBreaks) {
    const Outcome outcome = patina({"check", GetParam().string()});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
}

INSTANTIATE_TEST_SUITE_P(Every, ShippedPreset, testing::ValuesIn(shippedPresets()), nameOf);

} // namespace
} // namespace patina::tests::shipped_presets_test
