// SPDX-License-Identifier: GPL-3.0-or-later
// A change that makes the shaders of shipped presets longer is seen here without a clock.
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"

namespace patina::tests::predicted_instructions_test {
namespace {

namespace fs = std::filesystem;

/// Another version of the compiler has other numbers: with it only large changes are told.
constexpr double toleranceOfTheSameDriver = 0.02;
constexpr double toleranceOfAnother = 0.2;

/// Holds the driver that the instructions were counted with, and the count of each preset.
struct Table {
    std::string driver;
    std::map<std::string, double> instructions;
};

/// Counts the instructions of all shipped presets on RDNA 2 under three lights.
Table countedNow() {
    std::vector<std::string> command{"cost",
                                     "--gpu",
                                     "rdna2",
                                     "--as-it-is",
                                     "--json",
                                     "--scene",
                                     shipped("presets/three-lights.patina-scene.json").string()};
    for (const auto& entry : fs::recursive_directory_iterator(shipped("presets"))) {
        if (entry.path().string().ends_with(".patina.json")) {
            command.push_back(entry.path().string());
        }
    }
    const Outcome outcome = patina(Start{.arguments = std::move(command),
                                         .environment = {},
                                         .input = {},
                                         .timeLimitSeconds = 300.0});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    Table table{json.at("driver"), {}};
    for (const auto& preset : json.at("presets")) {
        const fs::path file = preset.at("preset").get<std::string>();
        const auto& stage = preset.at("ways").at(0).at("families").at("rdna2");
        table.instructions[fs::relative(file, shipped("presets")).string()] =
            stage.at("instructions").get<double>();
    }
    return table;
}

/// Reads lines of a count and a preset; the first one names the driver.
Table recorded() {
    std::istringstream lines(readFile(shipped("tests/cli/predicted_instructions.txt")));
    Table table;
    std::getline(lines, table.driver);
    table.driver.erase(0, 2); // "# "
    double count = 0.0;
    for (std::string preset; lines >> count >> preset;) {
        table.instructions[preset] = count;
    }
    return table;
}

std::string textOf(const Table& table) {
    std::string text = "# " + table.driver + '\n';
    for (const auto& [preset, count] : table.instructions) {
        text += std::to_string(int(count)) + ' ' + preset + '\n';
    }
    return text;
}

TEST(PredictedInstructions, OfAllShippedPresets_AreThoseRecorded) {
    const Table before = recorded();
    const Table now = countedNow();
    const double tolerance =
        before.driver == now.driver ? toleranceOfTheSameDriver : toleranceOfAnother;
    for (const auto& [preset, count] : now.instructions) {
        const auto found = before.instructions.find(preset);
        if (found == before.instructions.end()) {
            ADD_FAILURE() << preset << " is not recorded";
            continue;
        }
        EXPECT_LE(std::abs(count - found->second), tolerance * found->second)
            << preset << " had " << found->second << " instructions and has " << count;
    }
    EXPECT_EQ(now.instructions.size(), before.instructions.size());
    if (HasFailure()) {
        const fs::path file = fs::path(PATINA_BINARY_DIR) / "predicted_instructions.txt";
        writeFile(file, textOf(now));
        ADD_FAILURE() << "If that is meant, copy " << file << " to tests/cli";
    }
}

} // namespace
} // namespace patina::tests::predicted_instructions_test
