// SPDX-License-Identifier: GPL-3.0-or-later
// Which lines of a block survive floats of 16 bits.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"
#include "measure/interpreter/shader_evaluator.h"

namespace patina::tests::half_test {
namespace {

constexpr const char* descriptor = R"({"id": "coarse", "version": 1, "label": "Coarse",
  "summary": "For tests.", "applications": "Tests.", "source": "None", "parameters": [
    {"id": "diffuse.color", "label": "Diffuse", "doc": "Its colour.", "type": "color",
     "default": [0.5, 0.4, 0.3]}],
  "claims": ["finite", "non_negative"], "exemptions": {
    "reciprocal": "For tests.", "energy_conserving": "For tests.", "isotropic": "For tests.",
    "zero_below_horizon": "For tests."}})";

// Line 5 leaves the range of 16 bits, line 6 reads what has left it, line 7 has digits enough, and
// the sum on line 8 has a step of 0.5.
constexpr const char* shader = R"(// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"

vec3 coarse(Directions d, Coarse p) {
    float large = d.nl * 200000.0;
    float back = large * 0.000001;
    float half_ = d.nl * 0.5;
    float fine = (1000.0 + d.nl) - 1000.0;
    return p.diffuseColor * (back + half_ + fine);
}
)";

nlohmann::json reportOf(const TemporaryFolder& folder, std::vector<std::string> more = {}) {
    writeFile(folder / "patina/shaders/models/coarse.json", descriptor);
    writeFile(folder / "patina/shaders/models/coarse.glsl", shader);
    more.insert(more.begin(), {"check", "coarse", "--precision", "half", "--json"});
    const Outcome outcome = patina(Start{.arguments = std::move(more),
                                         .environment = {{"XDG_DATA_HOME", folder.path()}},
                                         .input = {}});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out).at(0);
}

TEST(HalfPrecision, LinesThatOverflowOrCancel_BreakByLineAndTheOthersHold) {
    const TemporaryFolder folder;
    const nlohmann::json report = reportOf(folder);
    const auto& lines = report.at("lines");
    ASSERT_EQ(lines.size(), 5u) << report.dump(1);
    const std::vector<bool> holds{false, false, true, false, true};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(lines[i].at("file"), "models/coarse.glsl");
        EXPECT_EQ(lines[i].at("line"), 5 + i);
        EXPECT_EQ(lines[i].at("holds"), bool(holds[i])) << lines[i].dump();
    }
    EXPECT_EQ(lines[2].at("code"), "float half_ = d.nl * 0.5;");
    EXPECT_NE(lines[0].at("why").get<std::string>().find("more than 65504"), std::string::npos);
    EXPECT_EQ(lines[3].at("why"), "its digits are too few");
    // Half of a step of 0.5 at most, of colours that sliders bring up to 1.
    EXPECT_NEAR(lines[3].at("atMost").get<double>(), 0.25, 0.01);
    EXPECT_EQ(report.at("whole").at("holds"), false);
    EXPECT_EQ(report.at("together"), (nlohmann::json{2, 4}));
    EXPECT_EQ(report.at("mixed").at("holds"), true);
}

TEST(HalfPrecision, WiderLimit_LetsMoreLinesHold) {
    const TemporaryFolder folder;
    const nlohmann::json report = reportOf(folder, {"--error", "0.26"});
    EXPECT_EQ(report.at("lines").at(3).at("holds"), true);
    EXPECT_EQ(report.at("lines").at(0).at("holds"), false) << "infinite whatever the limit";
}

TEST(HalfPrecision, OfAShippedPreset_NamesItsModelAndLines) {
    const Outcome outcome = patina({"check", gold, "--precision", "half"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const char* word : {"models/cook-torrance", "holds", "all lines", "together"}) {
        EXPECT_NE(outcome.out.find(word), std::string::npos) << word << '\n' << outcome.out;
    }
}

TEST(HalfPrecision, PriceWithoutTheDriver_SaysWhatToInstall) {
    const Outcome outcome =
        patina(Start{.arguments = {"check", "lambert", "--precision", "half", "--gpu", "rdna2"},
                     .environment = {{"VK_DRIVER_FILES", "/nowhere.json"}},
                     .input = {}});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("mesa-vulkan-drivers"), std::string::npos) << outcome.out;
}

TEST(HalfPrecision, Interrupted_PrintsTheLinesAndEndsAsAShellExpects) {
    const Outcome outcome =
        interrupted({"check", "strauss", "--precision", "half", "--gpu", "rdna2,rdna3", "--json"});
    EXPECT_EQ(outcome.exitCode, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("stopped"), std::string::npos) << outcome.err;
    EXPECT_TRUE(nlohmann::json::parse(outcome.out).is_array());
}

// IEEE 754-2019, binary16: 11 digits, emin -14, ties to even.
TEST(RoundedToHalf, TableOfBinary16_IsKept) {
    const double infinite = std::numeric_limits<double>::infinity();
    const std::pair<double, double> table[] = {{0.0, 0.0},
                                               {1.0, 1.0},
                                               {1.0 / 3.0, 0.333251953125},
                                               {-1.0 / 3.0, -0.333251953125},
                                               {2049.0, 2048.0},
                                               {2051.0, 2052.0},
                                               {65504.0, 65504.0},
                                               {65519.0, 65504.0},
                                               {65520.0, infinite},
                                               {-1e9, -infinite},
                                               {std::ldexp(1.0, -14), std::ldexp(1.0, -14)},
                                               {std::ldexp(1.0, -24), std::ldexp(1.0, -24)},
                                               {std::ldexp(1.0, -25), 0.0},
                                               {std::ldexp(1.5, -25), std::ldexp(1.0, -24)}};
    for (const auto& [number, expected] : table) {
        EXPECT_EQ(roundedToHalf(number), expected) << number;
    }
    EXPECT_TRUE(std::isnan(roundedToHalf(std::nan(""))));
}

/// The compiler of the family takes the text with 16-bit types, or there would be no price.
TEST(HalfPrecision, MixedForm_CompilesForACardAndStaysFinite) {
    const TemporaryFolder folder;
    const nlohmann::json report = reportOf(folder, {"--gpu", "rdna2", "--source"});
    EXPECT_EQ(report.at("mixed").at("holds"), true);
    EXPECT_EQ(report.at("mixed").at("finite"), true);
    const auto& cycles = report.at("cycles").at("rdna2");
    EXPECT_GT(cycles.at("float"), 0.0);
    EXPECT_GT(cycles.at("mixed"), 0.0);
    EXPECT_LE(cycles.at("cheapest"), cycles.at("float")) << "floats are among what is tried";
    const std::string text = report.at("mixedText");
    EXPECT_NE(text.find("float16_t half_ = (float16_t(d.nl) * float16_t(0.5));"), std::string::npos)
        << text;
    EXPECT_NE(text.find("float large = d.nl * 200000.0;"), std::string::npos) << "it breaks";
    EXPECT_NE(text.find("+ half_"), std::string::npos) << "a variable is not converted again";
}

} // namespace
} // namespace patina::tests::half_test
