// SPDX-License-Identifier: GPL-3.0-or-later
// `patina approximate` finds cheaper ways to compute blocks that it has never seen, says how far
// off they are, and writes them as blocks that work.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"
#include "measure/approximation/approximation_subject.h"
#include "measure/approximation/error_climb.h"
#include "measure/approximation/measured_text.h"
#include "measure/eval/eval_reference.h"
#include "measure/interpreter/shader_parser.h"
#include "measure/stability/edge_case_directions.h"
#include "measure/stability/edge_case_fields.h"
#include "measure/stability/sweep_cases.h"
#include "support/long_form.h"

namespace patina::tests::approximate_test {
namespace {

/// The parts of a descriptor that all models here share.
std::string descriptorOf(const std::string& id, const std::string& parameters) {
    return R"({"id": ")" + id + R"(", "version": 1, "label": "Tried", "summary": "A model to try.",
  "applications": "Tests.", "source": "See the shader.", "parameters": [)" +
           parameters + R"(],
  "claims": ["finite", "non_negative"], "exemptions": {
    "reciprocal": "It is as printed.", "energy_conserving": "It is as printed.",
    "isotropic": "It has a grain.", "zero_below_horizon": "It is as printed."}})";
}

constexpr const char* colors = R"(
  {"id": "diffuse.color", "label": "Diffuse", "doc": "Its colour.", "type": "color",
   "default": [0.5, 0.4, 0.3]},
  {"id": "specular.color", "label": "Highlight", "doc": "Its colour.", "type": "color",
   "default": [0.5, 0.5, 0.5]},
  {"id": "shininess", "label": "Shininess", "doc": "How sharp.", "type": "float", "default": 20,
   "min": 1, "max": 200, "softMin": 4, "softMax": 60})";

struct Paper {
    std::string id;
    std::string glsl;
    std::string parameters;
    /// Is how many cases a stated error is held on, those of the program and as many of the test.
    /// What takes long to judge has fewer in the long form, too.
    std::size_t casesInLongForm = 10000;

    std::size_t cases() const { return casesOf<std::size_t>(10000, casesInLongForm); }
};

// J. Kajiya and T. Kay, Rendering Fur with Three Dimensional Textures, SIGGRAPH 1989.
const Paper hair{"kajiya-kay", R"(// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"

// A thread along t: sin(t, l), and the cone about it, cos^p of the angle to it.
vec3 kajiyaKay(Directions d, KajiyaKay p) {
    float lightAngle = acos(clamp(d.lt, -1.0, 1.0));
    float viewAngle = acos(clamp(-d.vt, -1.0, 1.0));
    float lobe = pow(max(cos(lightAngle - viewAngle), 0.0), p.shininess);
    float sine = sqrt(max(1.0 - d.lt * d.lt, 0.0));
    return p.diffuseColor * sine + p.specularColor * lobe;
}
)",
                 colors};

// D. Banks, Illumination in Diverse Codimensions, SIGGRAPH 1994.
const Paper banks{"banks", R"(// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"

// The excess brightness of a thread is taken back by the power 4.8.
vec3 banks(Directions d, Banks p) {
    float sineLight = sqrt(max(1.0 - d.lt * d.lt, 0.0));
    float sineView = sqrt(max(1.0 - d.vt * d.vt, 0.0));
    float matte = pow(sineLight, 4.8);
    float lobe = pow(max(sineLight * sineView - d.lt * d.vt, 0.0), p.shininess);
    return (p.diffuseColor * matte + p.specularColor * lobe) * d.nl;
}
)",
                  colors, 100000};

// D. Edwards et al., The Halfway Vector Disk for BRDF Modeling, ACM TOG 25(1), 2006.
const Paper disc{"edwards", R"(// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"

// A density on the disc that half vectors fall on, and Fresnel's reflectance by Schlick.
vec3 edwards(Directions d, Edwards p) {
    float r2 = d.sin2h / (d.sin2h + d.cos2h);
    float density = (p.shininess + 1.0) * pow(max(1.0 - r2, 0.0), p.shininess);
    float share = 0.04 + 0.96 * pow(max(1.0 - d.lh, 0.0), 5.0);
    float lobe = share * density * d.nh / (4.0 * max(d.lh, 0.0001)) / max(max(d.nl, d.nv), 0.0001);
    return p.diffuseColor * d.nl + p.specularColor * (lobe * d.nl);
}
)",
                 colors};

void writePaper(const Paper& paper, const std::filesystem::path& shaders) {
    writeFile(shaders / "models" / (paper.id + ".glsl"), paper.glsl);
    writeFile(shaders / "models" / (paper.id + ".json"), descriptorOf(paper.id, paper.parameters));
}

Outcome approximated(std::vector<std::string> arguments,
                     std::map<std::string, std::string> environment = {}) {
    arguments.insert(arguments.begin(), "approximate");
    return patina(Start{.arguments = std::move(arguments),
                        .environment = std::move(environment),
                        .input = {},
                        .timeLimitSeconds = 240.0});
}

/// The case of a block of a folder with its defaults.
EvalCase caseOf(const Catalog& catalog, const std::string& id) {
    return *sweepVariant(catalog, defaultMaterial(*catalog.find(kinds::models, id)));
}

Catalog catalogWith(const std::filesystem::path& own) {
    const std::array roots{BlockRoot{shipped("shaders"), true}, BlockRoot{own, false}};
    return loadCatalog(roots);
}

class OfAPaper : public testing::TestWithParam<const Paper*> {};

TEST_P(OfAPaper, FrontHasTwoUsefulWaysThatKeepTheirErrorOnUnseenCases) {
    const Paper& paper = *GetParam();
    const TemporaryFolder folder;
    writePaper(paper, folder / "before");
    const Outcome outcome = approximated(
        {(folder / "before/models" / (paper.id + ".glsl")).string(), "--seconds", "30", "--cases",
         std::to_string(paper.cases()), "--json", "-o", (folder / "after/models").string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    const auto& ways = json.at("ways");
    ASSERT_GE(ways.size(), 2u) << outcome.out;
    EXPECT_EQ(json.at("unseenCases"), paper.cases());

    const Catalog before = catalogWith(folder / "before");
    const Catalog after = catalogWith(folder / "after");
    ASSERT_EQ(after.errors, Errors());
    const EvalCase exact = caseOf(before, paper.id);
    const auto text = MeasuredText::of(exact, shipped("shaders"));
    ASSERT_TRUE(text) << patina::text(text.error());
    const auto unseen = commonCases(
        exact, {.count = paper.cases(), .seed = 77, .firstRow = 9000, .rows = paper.cases() / 33});
    const JudgedCases judged = text->judged(texelsOfCases(unseen));
    double costBefore = json.at("exact").at("cost");
    double errorBefore = 0.0;
    for (const auto& way : ways) {
        EXPECT_LT(way.at("cost"), costBefore);
        EXPECT_GT(way.at("error"), errorBefore);
        costBefore = way.at("cost");
        errorBefore = way.at("error");
        EvalCase level = caseOf(after, paper.id);
        level.block.accuracy[level.block.block->accuracy.front().id] = way.at("level");
        const auto cheaper = MeasuredText::of(level, shipped("shaders"));
        ASSERT_TRUE(cheaper) << patina::text(cheaper.error());
        std::vector<EvalCase> cases = unseen;
        for (EvalCase& each : cases) {
            each.block.block = level.block.block;
            each.block.accuracy = level.block.accuracy;
        }
        const JudgedCases same{texelsOfCases(cases), judged.exact};
        const TextError error = cheaper->error({}, same, 10.0);
        EXPECT_TRUE(error.isSafe) << way.dump();
        EXPECT_LE(error.worst, way.at("atMost").get<double>()) << way.dump();
        EXPECT_LE(way.at("atMost").get<double>(), 0.25 + 1e-9) << "the budget is what is stated";
    }
    EXPECT_LT(ways.back().at("cost").get<double>(),
              0.95 * json.at("exact").at("cost").get<double>());
}

INSTANTIATE_TEST_SUITE_P(Approximate, OfAPaper, testing::Values(&hair, &banks, &disc),
                         [](const auto& each) {
                             return std::string(each.param == &hair    ? "KajiyaKay"
                                                : each.param == &banks ? "Banks"
                                                                       : "Edwards");
                         });

/// Tells how far a level of a written block is from the exact block in some cases.
TextError errorOfLevel(const EvalCase& exact, std::vector<EvalCase> cases, const Block& written,
                       const std::string& level) {
    const auto text = MeasuredText::of(exact, shipped("shaders"));
    EvalCase cheaper = exact;
    cheaper.block.block = &written;
    cheaper.block.accuracy[written.accuracy.back().id] = level;
    const auto changed = MeasuredText::of(cheaper, shipped("shaders"));
    if (!text || !changed) {
        return {INFINITY, INFINITY, false};
    }
    const JudgedCases judged = text->judged(texelsOfCases(cases));
    for (EvalCase& each : cases) {
        each.block.block = cheaper.block.block;
        each.block.accuracy = cheaper.block.accuracy;
    }
    return changed->error({}, {texelsOfCases(cases), judged.exact}, INFINITY);
}

// Height fog has a case of its own for a ray that is exactly level, and only such a ray comes to
// it.
TEST(Approximate, HeightFog_KeepsItsStatedErrorsAlongLevelRays) {
    const TemporaryFolder folder;
    const std::filesystem::path shaders = folder / "data/patina/shaders";
    const Outcome outcome = approximated(
        {"fog/height", "--seconds", "20", "--cases", "2000", "--json", "-o", shaders.string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("nothing chooses a level of a fog"), std::string::npos)
        << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    ASSERT_FALSE(json.at("ways").empty());
    const Catalog catalog = catalogWith(shaders);
    ASSERT_EQ(catalog.errors, Errors());
    const EvalCase exact = *defaultCase(catalog, *catalog.find(kinds::fog, "height"));
    std::vector<EvalCase> level;
    for (const double height : {-3.0, -1.0, -0.25, 0.5, 4.0}) {
        for (const double range : {0.5, 2.0, 20.0}) {
            level.push_back(exact);
            level.back().l = {1.0, height, -2.0};
            level.back().v = {0.6, 0.0, 0.8};
            level.back().number = range;
        }
    }
    for (const auto& way : json.at("ways")) {
        const TextError error = errorOfLevel(
            exact, level, *catalog.find(kinds::fog, "height-cheaper"), way.at("level"));
        EXPECT_LE(error.worst, way.at("atMost").get<double>()) << way.dump();
    }
    EXPECT_EQ(json.at("statedFor"),
              "ways of up to 1000 m in any direction, from within 5 m of the origin along each "
              "axis, with values that sliders reach: Density from 0 to 2 1/m, Base from -5 to 5 m, "
              "Thickness from 0 to 5 m");
    const Outcome chosen =
        patina(Start{.arguments = {"render", "--model", "lambert", "--fog", "height-cheaper",
                                   "--set", "fog.cheaper.height=found-1", "-o", folder / "a.png"},
                     .environment = {{"XDG_DATA_HOME", folder / "data"}},
                     .input = {}});
    EXPECT_EQ(chosen.exitCode, 1);
    EXPECT_NE(chosen.err.find("no level of the scene's fog is chosen"), std::string::npos)
        << chosen.err;
}

// No drawn case has a cosine of just one half, but an edge case has.
TEST(Approximate, ValueAtASinglePlace_IsKept) {
    const TemporaryFolder folder;
    const Paper dark{"dark-line",
                     "#include \"lib/directions.glsl\"\nvec3 darkLine(Directions d, DarkLine p) {\n"
                     "    float light = d.nl == 0.5 ? 0.0 : 1.0;\n"
                     "    return p.diffuseColor * (light * exp(-d.nl * d.nl));\n}\n",
                     colors};
    writePaper(dark, folder / "before");
    const Outcome outcome =
        approximated({(folder / "before/models/dark-line.glsl").string(), "--seconds", "15",
                      "--cases", "2000", "--json", "-o", (folder / "after/models").string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    const Catalog before = catalogWith(folder / "before");
    const Catalog after = catalogWith(folder / "after");
    EvalCase exact = caseOf(before, "dark-line");
    EvalCase line = exact;
    line.l = {0.0, std::sqrt(0.75), 0.5};
    line.v = {0.0, 0.0, 1.0};
    for (const auto& way : json.at("ways")) {
        const TextError error =
            errorOfLevel(exact, {line}, *after.find(kinds::models, "dark-line"), way.at("level"));
        EXPECT_LE(error.worst, way.at("atMost").get<double>()) << way.dump();
    }
    EXPECT_EQ(json.at("statedFor"), "light and viewer 3 degrees or more above the surface, with "
                                    "values that sliders reach: Shininess from 4 to 60");
}

TEST(StatedErrors, OfEachKind_SayWhichCasesTheyAreOf) {
    const Catalog catalog = catalogWith({});
    const auto placesOfBlock = [&catalog](std::string_view kind, const char* id) {
        return placesInWords(*defaultCase(catalog, *catalog.find(kind, id)));
    };
    EXPECT_EQ(placesOfBlock(kinds::fresnel, "schlick"), "cosines from 0 to 1");
    EXPECT_EQ(placesOfBlock(kinds::tone, "reinhard"), "radiance up to 2");
    EXPECT_EQ(placesOfBlock(kinds::lights, "point"),
              "points within 5 m of the origin along each axis");
    EXPECT_EQ(slidersInWords(*defaultCase(catalog, *catalog.find(kinds::fresnel, "schlick"))), "");
}

// The tangent from a rounded cosine loses half of its digits within 0.0003 of the normal, where few
// cases that are drawn evenly lie; what is stated has to hold there, too.
TEST(WorstCases, OfAnExactBlock_AreWhereFloatsLoseDigits) {
    const TemporaryFolder folder;
    Paper steep{"steepness",
                "#include \"lib/directions.glsl\"\nvec3 steepness(Directions d, Steepness p) {\n"
                "    return p.diffuseColor * sqrt(max(1.0 - d.nl * d.nl, 0.0));\n}\n",
                colors};
    writePaper(steep, folder.path());
    const Catalog catalog = catalogWith(folder.path());
    ASSERT_EQ(catalog.errors, Errors());
    const EvalCase exact = caseOf(catalog, "steepness");
    const auto text = MeasuredText::of(exact, shipped("shaders"));
    ASSERT_TRUE(text) << patina::text(text.error());
    const auto drawn = commonCases(exact, {.count = 2000, .seed = 5, .rows = 10});
    const CaseErrors errorsOf = [&text](const std::vector<EvalCase>& cases) {
        return text->errors({}, text->judged(texelsOfCases(cases)));
    };
    const WorstCases worst = worstCases(errorsOf, drawn, {}, [] { return false; });
    EXPECT_GT(worst.error, 1.5e-4);
    const JudgedCases judged = text->judged(texelsOfCases(drawn));
    EXPECT_LE(text->error({}, judged, 1.0).worst, worst.error);
    const JudgedCases there = text->judged(texelsOfCases(worst.cases));
    EXPECT_EQ(text->error({}, there, 1.0).worst, worst.error);
}

TEST(Approximate, WrittenBlock_IsValidAndPassesTheSweep) {
    const TemporaryFolder folder;
    writePaper(banks, folder / "before");
    const Outcome outcome =
        approximated({(folder / "before/models/banks.glsl").string(), "--seconds", "20", "--cases",
                      "1000", "-o", (folder / "data/patina/shaders").string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("shaders/models/banks.glsl"), std::string::npos)
        << "the folder of its kind: " << outcome.err;
    EXPECT_NE(outcome.out.find("power"), std::string::npos) << outcome.out;
    const std::map<std::string, std::string> own{{"XDG_DATA_HOME", folder / "data"}};
    const Outcome valid = patina(Start{
        .arguments = {"validate", (folder / "data/patina/shaders/models/banks.json").string()},
        .environment = own,
        .input = {}});
    EXPECT_EQ(valid.exitCode, 0) << valid.err;
    const Outcome checked = patina(Start{.arguments = {"check", "banks", "--json"},
                                         .environment = own,
                                         .input = {},
                                         .timeLimitSeconds = 120.0});
    for (const auto& defect : nlohmann::json::parse(checked.out).at("defects")) {
        const std::string text = defect.dump();
        for (const char* broken : {"not a number", "infinite", "negative"}) {
            EXPECT_EQ(text.find(broken), std::string::npos) << text;
        }
    }
}

// Its function is a copy's, whose choice has the name of the block that it is a copy of.
TEST(Approximate, BlockWithFoundWays_IsRefusedBeforeTheSearch) {
    const TemporaryFolder folder;
    writePaper(banks, folder.path());
    const std::filesystem::path file = folder / "models/banks.json";
    nlohmann::json descriptor = nlohmann::json::parse(readFile(file));
    descriptor["accuracy"] = {
        {{"id", "cheaper.other"},
         {"label", "Cheaper ways"},
         {"doc", "Found."},
         {"values",
          {{{"id", "exact"}, {"label", "Exact"}, {"doc", "As it is."}, {"exact", true}},
           {{"id", "found-1"}, {"label", "Found"}, {"doc", "Cheaper."}}}}}};
    writeFile(file, descriptor.dump());
    const Outcome outcome =
        approximated({(folder / "models/banks.glsl").string(), "-o", folder / "after"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("\"cheaper.other\""), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "after"));
}

TEST(Approximate, ModelOfMeasuredTables_IsRefusedWithTheReason) {
    const Outcome outcome = approximated({"measured"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("models/measured.json: it reads a file of measured numbers"),
              std::string::npos)
        << outcome.err;
}

TEST(Approximate, FolderOfTheBlockItself_IsRefused) {
    const TemporaryFolder folder;
    writePaper(banks, folder.path());
    const Outcome outcome =
        approximated({(folder / "models/banks.glsl").string(), "-o", (folder / "models").string()});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("another folder"), std::string::npos) << outcome.err;
    EXPECT_EQ(readFile(folder / "models/banks.glsl"), banks.glsl);
}

TEST(Approximate, ShippedBlock_GetsAnIdOfItsOwnAndItsTables) {
    const TemporaryFolder folder;
    const Outcome outcome = approximated(
        {"strauss", "--seconds", "12", "--cases", "1000", "--declared", "-o", folder / "models"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("terms=table"), std::string::npos) << "its own level, judged too";
    EXPECT_NE(outcome.err.find("models/strauss-cheaper.glsl"), std::string::npos) << outcome.err;
    const Catalog catalog = catalogWith(folder.path());
    EXPECT_EQ(catalog.errors, Errors());
    EXPECT_NE(catalog.find(kinds::models, "strauss-cheaper"), nullptr);
}

TEST(Approximate, Preset_HasItsValuesFoldedAndIsDrawnAndTimed) {
    const Outcome outcome = approximated({shipped("presets/minnaert/velvet.patina.json"),
                                          "--seconds", "40", "--cases", "1000", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_NE(json.at("frame").at("against").get<std::string>().find("in double precision"),
              std::string::npos)
        << json.at("frame").dump();
    const auto& ways = json.at("ways");
    for (const auto& way : ways) {
        const auto& frame = way.at("frame");
        EXPECT_GT(frame.at("error").at("mean").get<double>(), 0.0) << way.dump();
        EXPECT_GT(frame.at("time").at("ratio").get<double>(), 0.0) << way.dump();
    }
    EXPECT_TRUE(std::ranges::any_of(ways, [](const auto& way) { return way.at("forValues"); }))
        << outcome.out;
}

TEST(Approximate, TextThatDoesNotCompile_IsTheMistakeAtItsLine) {
    const TemporaryFolder folder;
    Paper wrong = banks;
    wrong.glsl.replace(wrong.glsl.find("* d.nl"), 6, "* d.missing");
    writePaper(wrong, folder.path());
    const Outcome outcome = approximated({(folder / "models/banks.glsl").string()});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("banks.glsl:10"), std::string::npos) << outcome.err;
    wrong.glsl.replace(wrong.glsl.find("* d.missing"), 11, "* ;");
    writePaper(wrong, folder.path());
    const Outcome unparsed = approximated({(folder / "models/banks.glsl").string()});
    EXPECT_EQ(unparsed.exitCode, 1);
    EXPECT_NE(unparsed.err.find("banks.glsl:10"), std::string::npos) << unparsed.err;
}

TEST(Approximate, FunctionWithNothingToLeaveOut_SaysSo) {
    const TemporaryFolder folder;
    Paper plain = banks;
    plain.glsl = "#include \"lib/directions.glsl\"\nvec3 banks(Directions d, Banks p) {\n"
                 "    return p.diffuseColor;\n}\n";
    writePaper(plain, folder.path());
    const Outcome outcome =
        approximated({(folder / "models/banks.glsl").string(), "--seconds", "5"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("nothing cheaper was found"), std::string::npos) << outcome.out;
}

TEST(Approximate, DeepAndEndlessTexts_EndWithAMessage) {
    const TemporaryFolder folder;
    Paper deep = banks;
    deep.glsl = "#include \"lib/directions.glsl\"\nvec3 banks(Directions d, Banks p) {\n    return "
                "p.diffuseColor * " +
                std::string(5000, '(') + "d.nl" + std::string(5000, ')') + ";\n}\n";
    writePaper(deep, folder.path());
    const Outcome outcome =
        approximated({(folder / "models/banks.glsl").string(), "--seconds", "5"});
    EXPECT_LE(outcome.exitCode, 1) << outcome.err;
    Paper large = banks;
    large.glsl += std::string(std::size_t(2) << 20, '\n');
    writePaper(large, folder.path());
    EXPECT_EQ(approximated({(folder / "models/banks.glsl").string()}).exitCode, 1);
}

TEST(Approximate, WithoutSollyaAndDriver_SaysWhatToInstallAndCountsInstructions) {
    const TemporaryFolder folder;
    writePaper(disc, folder.path());
    const Outcome outcome = approximated(
        {(folder / "models/edwards.glsl").string(), "--seconds", "40", "--cases", "1000", "--json"},
        {{"PATH", "/nowhere"}, {"VK_DRIVER_FILES", "/nowhere.json"}});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("apt-get install sollya"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("mesa-vulkan-drivers"), std::string::npos) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json.at("unit"), "instructions");
    EXPECT_GE(json.at("ways").size(), 2u) << outcome.out;
}

TEST(Approximate, MoreCasesThanThereIsTimeFor_EndsInTimeAndSaysHowManyWereJudged) {
    const TemporaryFolder folder;
    writePaper(disc, folder.path());
    const auto began = std::chrono::steady_clock::now();
    const Outcome outcome = approximated({(folder / "models/edwards.glsl").string(), "--seconds",
                                          "8", "--cases", "10000000", "--json"});
    const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - began;
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_LT(gone.count(), 8.0 + 7.0) << outcome.out;
    EXPECT_NE(outcome.err.find("the time was over"), std::string::npos) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_TRUE(json.at("ways").empty() || json.at("unseenCases") < 10000000) << outcome.out;
}

TEST(Approximate, Interrupted_ChecksAndPrintsWhatItHasFound) {
    const Outcome outcome = interrupted({"approximate", "oren-nayar", "--cases", "1000", "--json"});
    EXPECT_EQ(outcome.exitCode, 130) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json.at("finished"), false);
    EXPECT_EQ(json.at("checkedOnDevice"), true);
}

TEST(Approximate, UnknownName_SaysWhatIsExpected) {
    const Outcome outcome = approximated({"blinn-fong"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("blinn-phong"), std::string::npos) << outcome.err;
    EXPECT_NE(approximated({"/nowhere/banks.glsl"}).err.find("no such file"), std::string::npos);
    EXPECT_NE(approximated({"phong", "--gpu", "gcn,rdna2"}).err.find("one family"),
              std::string::npos);
    const TemporaryFolder folder;
    writeFile(folder / "elsewhere/banks.glsl", banks.glsl);
    EXPECT_NE(approximated({(folder / "elsewhere/banks.glsl").string()}).err.find("models/"),
              std::string::npos);
}

std::vector<EvalPlace> placesOf(const EvalCase& variant, std::size_t count) {
    auto places = variant.subject == EvalCase::Subject::Fields
                      ? ordinaryFields(fieldsOf(variant), count)
                      : ordinaryPlaces(variant.subject, count);
    return places.empty() ? std::vector<EvalPlace>(1) : places;
}

/// The largest difference between what the parsed text and the compiled code of a variant give.
double largestDifference(const EvalCase& variant) {
    const auto text = MeasuredText::of(variant, shipped("shaders"));
    EXPECT_TRUE(text) << evalJson(variant) << patina::text(text ? Errors() : text.error());
    std::vector<EvalCase> cases;
    for (EvalCase& row : ordinaryRows(variant, 4)) {
        for (const EvalPlace& place : placesOf(variant, 12)) {
            static_cast<EvalPlace&>(row) = place;
            cases.push_back(row);
        }
    }
    if (!text) {
        return 0.0;
    }
    const JudgedCases judged = text->judged(texelsOfCases(cases));
    double worst = 0.0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto compiled = evaluatedInDouble(cases[i]);
        const auto parsed = std::span(judged.exact).subspan(i * text->results(), text->results());
        worst = std::max(worst, compiled ? text->errorOf(*compiled, parsed) : INFINITY);
    }
    return worst;
}

// The two differ by the fits of lib/elementary.glsl, whose relative errors are up to 6e-6, and by
// the rounding of values to floats.
TEST(ShaderEvaluator, EveryShippedBlock_GivesWhatItsCompiledCodeGives) {
    const Catalog catalog = catalogWith({});
    std::size_t tried = 0;
    for (const Block& block : catalog.blocks) {
        const std::vector<EvalCase> variants = sweepVariants(catalog, block);
        const bool readsFile = std::ranges::any_of(
            block.parameters, [](const Parameter& each) { return infoOf(each.type).isTable; });
        for (std::size_t i = 0; i < std::min<std::size_t>(variants.size(), 3) && !readsFile; ++i) {
            EXPECT_LE(largestDifference(variants[i]), 2e-5) << block.kind << '/' << block.id;
            ++tried;
        }
    }
    EXPECT_GT(tried, 60u);
}

TEST(ShaderEvaluator, FloatPrecision_RoundsEachOperation) {
    const ShaderSource source{
        "float f(float x) {\n    return (1.0 + x) - 1.0;\n}\n", {"generated"}, {}};
    const auto syntax = parsedShader(source, "f");
    ASSERT_TRUE(syntax);
    const double x = 1e-9;
    double inFloat = -1.0;
    double inDouble = -1.0;
    ShaderEvaluator(*syntax, ShaderPrecision::Float).call(0, {&x, 1}, {}, {&inFloat, 1});
    ShaderEvaluator(*syntax, ShaderPrecision::Double).call(0, {&x, 1}, {}, {&inDouble, 1});
    EXPECT_EQ(inFloat, 0.0);
    EXPECT_NEAR(inDouble, 1e-9, 1e-16);
}

TEST(ShaderEvaluator, FloatTooSmallToBeNormal_IsNone) {
    const ShaderSource source{
        "float f(float x) {\n    return x * 1e-10 * 1e10;\n}\n", {"generated"}, {}};
    const auto syntax = parsedShader(source, "f");
    ASSERT_TRUE(syntax);
    const double x = 1e-30;
    double inFloat = -1.0;
    ShaderEvaluator(*syntax, ShaderPrecision::Float).call(0, {&x, 1}, {}, {&inFloat, 1});
    EXPECT_EQ(inFloat, 0.0);
}

TEST(ShaderEvaluator, LoopWithoutAnEnd_GivesNoNumber) {
    const ShaderSource source{"float f(float x) {\n    while (true) {\n        x += 1.0;\n    }\n"
                              "    return x;\n}\n",
                              {"generated"},
                              {}};
    const auto syntax = parsedShader(source, "f");
    ASSERT_TRUE(syntax);
    const double x = 0.0;
    double y = 0.0;
    ShaderEvaluator(*syntax, ShaderPrecision::Double).call(0, {&x, 1}, {}, {&y, 1});
    EXPECT_TRUE(std::isnan(y));
}

} // namespace
} // namespace patina::tests::approximate_test
