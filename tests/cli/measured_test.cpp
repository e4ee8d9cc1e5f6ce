// SPDX-License-Identifier: GPL-3.0-or-later
// A file of measurements is a preset for every command that shows one.
#include <cstring>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"

namespace patina::measured_test {
namespace {

using tests::Outcome;
using tests::patina;
using tests::readFile;
using tests::TemporaryFolder;
using tests::writeFile;

/// A MERL file of 2 x 2 x 2 bins that is matte with an albedo of about 0.3, in the file's units.
std::string matteFile() {
    constexpr int bins[3] = {2, 2, 2};
    std::string bytes(sizeof bins + 24 * sizeof(double), '\0');
    std::memcpy(bytes.data(), bins, sizeof bins);
    for (std::size_t i = 0; i < 24; ++i) {
        const double unit = i < 8 ? 1.0 / 1500.0 : i < 16 ? 1.15 / 1500.0 : 1.66 / 1500.0;
        const double value = 0.3 / 3.14159265358979 / unit;
        std::memcpy(&bytes[sizeof bins + i * sizeof value], &value, sizeof value);
    }
    return bytes;
}

TEST(MeasuredFile, IsRenderedPlottedAndChecked) {
    const TemporaryFolder folder;
    const std::string file = folder / "grey.binary";
    writeFile(file, matteFile());
    const std::string picture = folder / "grey.png";
    const Outcome drawn = patina({"render", file, "-o", picture, "--size", "32x32"});
    EXPECT_EQ(drawn.exitCode, 0) << drawn.err;
    EXPECT_GT(readFile(picture).size(), 100u);
    const Outcome lobe = patina({"lobe", file, "--plot", "albedo"});
    EXPECT_EQ(lobe.exitCode, 0) << lobe.err;
    EXPECT_NE(lobe.out.find(",0,0.3"), std::string::npos) << lobe.out.substr(0, 400);
    const Outcome checked = patina({"check", file});
    EXPECT_EQ(checked.exitCode, 0) << checked.err << checked.out;
}

TEST(MeasuredFile, DamagedOrTooLong_EndsInAMessage) {
    const TemporaryFolder folder;
    const std::string file = folder / "short.binary";
    writeFile(file, matteFile().substr(0, 50));
    const Outcome outcome = patina({"render", file, "-o", folder / "a.png"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("short.binary: byte 50: "), std::string::npos) << outcome.err;
}

TEST(MeasuredFile, BehindAPresetAndUnreadable_EndsEveryCommandAndIsAllowedOutside) {
    const TemporaryFolder folder;
    writeFile(folder / "grey.binary", matteFile());
    std::filesystem::create_directory(folder / "presets");
    const std::string preset = folder / "presets/grey.patina.json";
    writeFile(
        preset,
        R"({"format": "patina.preset", "version": 1, "model": {"id": "measured", "version": 1},
                         "parameters": {"file": "../grey.binary"}})");
    const std::string picture = folder / "a.png";
    const std::vector<std::vector<std::string>> commands{
        {"render", preset, "-o", picture, "--size", "32x32"},
        {"lobe", preset},
        {"match", "--to", preset, "--model", "lambert", "--samples", "64"}};
    for (std::vector<std::string> command : commands) {
        const Outcome withheld = patina(command);
        EXPECT_EQ(withheld.exitCode, 1) << command.front();
        EXPECT_NE(withheld.err.find("grey.binary"), std::string::npos) << withheld.err;
        command.emplace_back("--allow-outside");
        const Outcome allowed = patina(command);
        EXPECT_EQ(allowed.exitCode, 0) << command.front() << allowed.err;
    }
    writeFile(folder / "grey.binary", matteFile().substr(0, 50));
    const Outcome damaged = patina({"effects", preset, "--allow-outside"});
    EXPECT_EQ(damaged.exitCode, 1);
    EXPECT_NE(damaged.err.find("grey.binary: byte 50: "), std::string::npos) << damaged.err;
}

} // namespace
} // namespace patina::measured_test
