// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <filesystem>

#include <gtest/gtest.h>

#include "cli/patina_program.h"
#include "support/long_form.h"

namespace patina::tests::shipped_presets_test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> presetsIn(const fs::path& folder) {
    std::vector<std::string> presets;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().string().ends_with(".patina.json")) {
            presets.push_back(entry.path().string());
        }
    }
    std::ranges::sort(presets);
    return presets;
}

/// Each model's presets are in a folder of their own.
std::vector<fs::path> foldersOfPresets() {
    std::vector<fs::path> folders;
    for (const fs::directory_entry& entry : fs::directory_iterator(shipped("presets"))) {
        if (entry.is_directory() && !presetsIn(entry.path()).empty()) {
            folders.push_back(entry.path());
        }
    }
    std::ranges::sort(folders);
    return folders;
}

/// "he_torrance" of presets/he-torrance.
std::string nameOf(const testing::TestParamInfo<fs::path>& info) {
    std::string name = info.param.filename().string();
    std::ranges::replace_if(
        name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
    return name;
}

class ShippedPresets : public testing::TestWithParam<fs::path> {};

/// A third of the sweep that a user gets; all of it in the long form.
TEST_P(ShippedPresets, AreCheckedInTheirEdgeCases_NothingBreaks) {
    const std::vector<std::string> presets = presetsIn(GetParam());
    Start start{.arguments = {"check"}, .environment = {}, .input = {}, .timeLimitSeconds = 240.0};
    start.arguments.insert(start.arguments.end(), presets.begin(), presets.end());
    start.arguments.insert(start.arguments.end(), {"--cases", casesOf("100000", "300000")});
    const Outcome outcome = patina(start);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
    for (const std::string& preset : presets) {
        EXPECT_NE(outcome.out.find(preset), std::string::npos) << preset;
    }
}

INSTANTIATE_TEST_SUITE_P(Every, ShippedPresets, testing::ValuesIn(foldersOfPresets()), nameOf);

} // namespace
} // namespace patina::tests::shipped_presets_test
