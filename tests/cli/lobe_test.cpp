// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::lobe_test {
namespace {

/// Is a row of what `patina lobe` prints.
struct Row {
    std::string line;
    double degrees = 0.0;
    double red = 0.0;
};

std::vector<Row> rowsOf(const std::string& csv) {
    std::vector<Row> rows;
    std::istringstream stream(csv);
    std::string text;
    std::getline(stream, text); // the names of columns
    while (std::getline(stream, text)) {
        std::istringstream cells(text);
        std::string material;
        std::string line;
        std::string degrees;
        std::string red;
        std::getline(cells, material, ',');
        std::getline(cells, line, ',');
        std::getline(cells, degrees, ',');
        std::getline(cells, red, ',');
        rows.push_back({line, std::stod(degrees), std::stod(red)});
    }
    return rows;
}

std::vector<Row> plotted(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "lobe");
    const Outcome outcome = patina(std::move(arguments));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return rowsOf(outcome.out);
}

TEST(LobeCommand, Polar_OfLambertIsItsColourOverPi) {
    const auto rows = plotted({"--model", "lambert", "--set", "diffuse.color=0.5,0.5,0.5"});
    ASSERT_GT(rows.size(), 100u);
    for (const Row& row : rows) {
        if (std::abs(row.degrees) < 89.999) { // at the horizon nothing is seen
            EXPECT_NEAR(row.red, 0.5 / std::numbers::pi, 1e-9) << row.degrees;
        }
    }
}

TEST(LobeCommand, Polar_PeaksOnTheSideTheLightIsMirroredTo) {
    const auto rows = plotted({"--model", "phong", "--set", "shininess=200", "--angle", "30"});
    const auto peak = std::ranges::max_element(rows, {}, &Row::red);
    EXPECT_NEAR(peak->degrees, 30.0, 1e-6);
}

TEST(LobeCommand, Terms_AddUpToTheWhole) {
    const auto at = [](const std::string& term) {
        const auto rows =
            plotted({"--model", "ashikhmin-shirley", "--term", term, "--angle", "20"});
        for (const Row& row : rows) {
            if (row.degrees == 30.0) {
                return row.red;
            }
        }
        return std::nan("");
    };
    EXPECT_NEAR(at("diffuse") + at("highlight"), at("whole"), 1e-9);
}

TEST(LobeCommand, Masking_IsAShareAndASingleLine) {
    for (const Row& row : plotted({"--model", "cook-torrance", "--term", "masking"})) {
        EXPECT_EQ(row.line, "masking");
        EXPECT_GE(row.red, 0.0);
        EXPECT_LE(row.red, 1.0 + 1e-9);
    }
    const Outcome none = patina({"lobe", "--model", "phong", "--term", "masking"});
    EXPECT_EQ(none.exitCode, 1);
    EXPECT_NE(none.err.find("Phong does not tell a masking apart"), std::string::npos) << none.err;
}

TEST(LobeCommand, Albedo_OfLambertIsNeverAboveOne) {
    for (const Row& row : plotted({"--model", "lambert", "--plot", "albedo"})) {
        EXPECT_LE(row.red, 1.0 + 1e-4);
        EXPECT_EQ(row.line, "albedo");
    }
}

TEST(LobeCommand, Fresnel_OfGlassHasBothPolarisationsFromBothSides) {
    const auto rows = plotted({"--model", "cook-torrance", "--fresnel", "dielectric", "--set",
                               "fresnel.index.inside=1.5", "--plot", "fresnel"});
    std::map<std::string, double> at60;
    for (const Row& row : rows) {
        if (std::abs(row.degrees - 60.0) < 1e-9) {
            at60[row.line] = row.red;
        }
    }
    EXPECT_NEAR(at60["from outside R_s"], 0.176571488082841, 1e-9);
    EXPECT_NEAR(at60["from outside R_p"], 0.00180193752158504, 1e-9);
    EXPECT_NEAR(at60["from outside T"], 1.0 - 0.0891867128022128, 1e-9);
    EXPECT_EQ(at60["from inside R"], 1.0); // beyond the critical angle
    EXPECT_EQ(at60["from inside T_p"], 0.0);
}

TEST(LobeCommand, Fresnel_OfAFilmSaysThatItsPolarisationsAreOfTheBareInterface) {
    std::map<std::string, double> facing;
    for (const Row& row :
         plotted({"--model", "cook-torrance", "--fresnel", "thin-film", "--plot", "fresnel"})) {
        facing.try_emplace(row.line, row.red);
    }
    EXPECT_FALSE(facing.contains("from outside R"));
    ASSERT_TRUE(facing.contains("bare: from outside R") && facing.contains("bare: from outside T"));
    const double n = double(1.52f); // is kept as a float
    EXPECT_NEAR(facing["bare: from outside R"], std::pow((n - 1.0) / (n + 1.0), 2.0), 1e-9);
}

TEST(LobeCommand, Spectrum_IsOverTheWavelength) {
    const Outcome outcome = patina(
        {"lobe", "--model", "cook-torrance", "--fresnel", "dispersive", "--plot", "spectrum"});
    EXPECT_TRUE(outcome.out.starts_with("material,line,nanometres,")) << outcome.err;
    const auto rows = rowsOf(outcome.out);
    ASSERT_GT(rows.size(), 300u);
    EXPECT_EQ(rows.front().line, "index n");
    EXPECT_EQ(rows.front().degrees, 380.0);
    EXPECT_NEAR(rows.front().red, 1.5337, 1e-3);
    EXPECT_EQ(rows.back().line, "R facing the surface");
}

TEST(LobeCommand, Drawing_HasAFormByItsName) {
    const TemporaryFolder folder;
    for (const char* plot :
         {"polar", "albedo", "fresnel", "spectrum", "half", "float32", "float16"}) {
        const std::string svg = (folder / (std::string(plot) + ".svg")).string();
        const Outcome outcome = patina({"lobe", "--model", "cook-torrance", "--fresnel",
                                        "conductor", "--plot", plot, "-o", svg});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        const std::string text = readFile(svg);
        EXPECT_TRUE(text.starts_with("<svg")) << plot;
        EXPECT_EQ(text.find("nan"), std::string::npos) << plot;
        EXPECT_EQ(text.find("inf"), std::string::npos) << plot;
        EXPECT_NE(text.find("Cook-Torrance"), std::string::npos) << plot;
        EXPECT_EQ(text.find("transmitted T") != std::string::npos,
                  std::string_view(plot) == "fresnel");
    }
    const std::string masking = (folder / "masking.svg").string();
    ASSERT_EQ(
        patina({"lobe", "--model", "cook-torrance", "--term", "masking", "-o", masking}).exitCode,
        0);
    EXPECT_NE(readFile(masking).find("masking, of 1"), std::string::npos);
    EXPECT_EQ(readFile(masking).find("1/sr"), std::string::npos);
    ASSERT_EQ(patina({"lobe", gold, gold, "-o", (folder / "a.png").string()}).exitCode, 0);
    EXPECT_TRUE(readFile(folder / "a.png").starts_with("\x89PNG"));
}

TEST(LobeCommand, Float32_IsAFewUnitsInTheLastPlaceOfDouble) {
    for (const Row& row : plotted({"--model", "cook-torrance", "--plot", "float32"})) {
        EXPECT_GE(row.red, 0.0);
        EXPECT_LT(row.red, 100.0) << row.degrees;
    }
}

/// A diffuse surface takes one or two operations, each of which is at most half a unit off, and so
/// is what it is given; a highlight's power loses more.
TEST(LobeCommand, Float16_IsAUnitInTheLastPlaceOfALambertSurfaceAndMoreOfAHighlight) {
    double worst = 0.0;
    for (const Row& row : plotted({"--model", "lambert", "--plot", "float16"})) {
        worst = std::max(worst, row.red);
    }
    EXPECT_GT(worst, 0.1);
    EXPECT_LT(worst, 3.0);
    double worstOfHighlight = 0.0;
    for (const Row& row : plotted({"--model", "cook-torrance", "--plot", "float16"})) {
        worstOfHighlight = std::max(worstOfHighlight, row.red);
        EXPECT_LE(row.red, 2048.0);
    }
    EXPECT_GT(worstOfHighlight, worst);
}

TEST(LobeCommand, UsersModel_IsPlottedByTheDevice) {
    const TemporaryFolder data;
    std::filesystem::create_directories(data / "patina/shaders/models");
    const auto stem = data / "patina/shaders/models/half-grey";
    writeFile(stem.string() + ".json", R"({
  "id": "half-grey", "version": 1, "label": "Half grey", "summary": "s", "applications": "a",
  "source": "a test", "doc": "d", "parameters": [], "claims": ["finite"]
})");
    writeFile(stem.string() + ".glsl", "// SPDX-License-"
                                       "Identifier: MIT-0\n"
                                       "#include \"lib/directions.glsl\"\n"
                                       "vec3 halfGrey(Directions d, HalfGrey p) {\n"
                                       "    return vec3(0.5 * d.nl);\n}\n");
    for (const auto& [plot, value] :
         {std::pair{"polar", 0.5 / std::numbers::pi}, std::pair{"albedo", 0.5}}) {
        const Outcome outcome =
            patina(Start{.arguments = {"lobe", "--model", "half-grey", "--plot", plot},
                         .environment = {{"XDG_DATA_HOME", data.path().string()}},
                         .input = {}});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        const auto rows = rowsOf(outcome.out);
        ASSERT_GT(rows.size(), 5u);
        for (const Row& row : rows) {
            if (std::abs(row.degrees) < 89.0) {
                EXPECT_NEAR(row.red, value, 1e-4) << plot << ' ' << row.degrees;
            }
        }
    }
}

TEST(LobeCommand, DrawingModels_SayWhatMeansNothingForThem) {
    for (const char* model : {"gooch", "toon", "halftone", "hatching"}) {
        for (const char* plot : {"polar", "albedo", "half"}) {
            const Outcome outcome = patina({"lobe", "--model", model, "--plot", plot});
            EXPECT_EQ(outcome.exitCode, 1) << model;
            EXPECT_NE(outcome.err.find("no share of the light"), std::string::npos) << outcome.err;
        }
    }
}

TEST(LobeCommand, WrongArguments_AreMessages) {
    const std::vector<std::vector<std::string>> wrong{
        {"lobe"},
        {"lobe", gold, "--angle", "91"},
        {"lobe", gold, "--angle", "nan"},
        {"lobe", gold, "--plot", "cubic"},
        {"lobe", gold, "-o", "a.jpg"},
        {"lobe", "no-such-file.patina.json"},
        {"lobe", gold, gold, "--plot", "half"},
        {"lobe", "--model", "strauss", "--term", "diffuse"},
        {"lobe", "--model", "phong", "--plot", "fresnel"}};
    for (const auto& arguments : wrong) {
        const Outcome outcome = patina(arguments);
        EXPECT_EQ(outcome.exitCode, 1) << arguments.back();
        EXPECT_NE(outcome.err, "") << arguments.back();
        EXPECT_EQ(outcome.out, "") << arguments.back();
    }
}

} // namespace
} // namespace patina::tests::lobe_test
