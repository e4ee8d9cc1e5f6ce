// SPDX-License-Identifier: GPL-3.0-or-later
// A model that wrote a file finds its own values in it again.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "measure/eval/model_values.h"
#include "measure/match/model_matches.h"
#include "measure/stability/sweep_cases.h"
#include "support/measured_files.h"
#include "support/program.h"

namespace patina::match_test {
namespace {

using std::numbers::pi;
using tests::merlBytes;
using tests::RglFile;
using tests::TemporaryFolder;
using tests::writeFile;

const Catalog& catalog() {
    static const Catalog shipped = loadCatalog(standardBlockRoots());
    return shipped;
}

/// A material whose values are none of the defaults.
Material hidden(const std::string& model, const Values& values) {
    Material material = defaultMaterial(*catalog().find(kinds::models, model));
    for (const auto& [id, value] : values) {
        material.model.parameters[id] = value;
    }
    return material;
}

tests::Reflectance reflectanceOf(const Material& material) {
    const ModelValues values = *ModelValues::of(*sweepVariant(catalog(), material), catalog());
    return [values](const DirectionPair& pair) { return values.at(pair) / (pi * pair.l.z); };
}

/// Compares all numbers that a fit may change.
void expectFound(const Material& found, const Values& values) {
    for (const auto& [id, value] : values) {
        const Value& fitted = found.model.parameters.at(id);
        if (const auto* color = std::get_if<glm::dvec3>(&value)) {
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(std::get<glm::dvec3>(fitted)[c], (*color)[c], 1e-3) << id;
            }
        } else {
            const double wanted = std::get<double>(value);
            EXPECT_NEAR(std::get<double>(fitted), wanted, 1e-3 * std::max(wanted, 1.0)) << id;
        }
    }
}

ModelMatches matched(const std::string& model, const MatchTarget& target) {
    return fittedMaterials({defaultMaterial(*catalog().find(kinds::models, model))}, target, {},
                           catalog(), [](double, const ModelMatches&) { return true; });
}

struct Case {
    const char* model;
    Values values;
};

class Recovered : public testing::TestWithParam<Case> {};

TEST_P(Recovered, FromAMerlFile_WithinAThousandth) {
    const TemporaryFolder folder;
    const Material material = hidden(GetParam().model, GetParam().values);
    writeFile(folder / "a.binary", merlBytes({30, 30, 60}, reflectanceOf(material)));
    const auto measured = readMeasured(folder / "a.binary");
    ASSERT_TRUE(measured) << measured.error().text();
    const ModelMatches matches = matched(GetParam().model, *matchTarget(**measured, 4096));
    ASSERT_EQ(matches.rows.size(), 1u);
    EXPECT_LT(matches.rows[0].relative, 1e-4);
    expectFound(matches.rows[0].material, GetParam().values);
}

INSTANTIATE_TEST_SUITE_P(
    Models, Recovered,
    testing::Values(
        Case{"lambert", {{"diffuse.color", glm::dvec3(0.7, 0.3, 0.1)}}},
        Case{"minnaert", {{"diffuse.color", glm::dvec3(0.2, 0.3, 0.6)}, {"darkening", 1.7}}},
        Case{"oren-nayar", {{"diffuse.color", glm::dvec3(0.5, 0.4, 0.2)}, {"roughness", 0.6}}}),
    [](const auto& instance) {
        std::string name = instance.param.model;
        std::erase(name, '-');
        return name;
    });

/// Compares both roughnesses; the grain may also be turned by 90 degrees, and these exchanged.
void expectGrain(const Material& found, double along, double across) {
    const auto number = [&found](const char* id) {
        return std::get<double>(found.model.parameters.at(id));
    };
    const double angle = std::abs(std::remainder(number("tangent.angle"), 180.0));
    EXPECT_NEAR(angle < 45.0 ? angle : 90.0 - angle, 0.0, 0.1);
    EXPECT_NEAR(number(angle < 45.0 ? "roughness.x" : "roughness.y"), along, 1e-3);
    EXPECT_NEAR(number(angle < 45.0 ? "roughness.y" : "roughness.x"), across, 1e-3);
}

TEST(Matched, AnisotropicPreset_IsFoundFromTheDefaults) {
    const Values values{
        {"diffuse.color", glm::dvec3(0.1, 0.4, 0.3)}, {"roughness.x", 0.35}, {"roughness.y", 0.2}};
    const auto target =
        matchTarget(*sweepVariant(catalog(), hidden("ward", values)), 2048, catalog());
    ASSERT_TRUE(target);
    const ModelMatches matches = matched("ward", *target);
    ASSERT_EQ(matches.rows.size(), 1u);
    EXPECT_LT(matches.rows[0].relative, 1e-4);
    expectGrain(matches.rows[0].material, 0.35, 0.2);
}

TEST(Matched, OtherChoiceOfTheModel_IsFound) {
    Material material = hidden("oren-nayar", {{"roughness", 0.9}});
    material.model.parameters["form"] = std::string("eon");
    const auto target = matchTarget(*sweepVariant(catalog(), material), 1024, catalog());
    ASSERT_TRUE(target);
    const ModelMatches matches = matched("oren-nayar", *target);
    ASSERT_EQ(matches.rows.size(), 1u);
    EXPECT_EQ(std::get<std::string>(matches.rows[0].material.model.parameters.at("form")), "eon");
    EXPECT_LT(matches.rows[0].relative, 1e-4);
}

TEST(Matched, AnisotropicSurfaceInAnRglFile_IsFound) {
    const TemporaryFolder folder;
    const Values values{{"roughness.x", 0.4}, {"roughness.y", 0.25}};
    const auto bytes = RglFile{.azimuths = 9}.bytes(reflectanceOf(hidden("ward", values)));
    writeFile(folder / "a.bsdf", bytes);
    const auto measured = readMeasured(folder / "a.bsdf");
    ASSERT_TRUE(measured) << measured.error().text();
    const ModelMatches matches = matched("ward", *matchTarget(**measured, 2048));
    ASSERT_EQ(matches.rows.size(), 1u);
    expectGrain(matches.rows[0].material, 0.4, 0.25);
}

TEST(Matched, Ended_ReturnsWhatWasFittedUntilThen) {
    const auto target =
        matchTarget(*sweepVariant(catalog(), hidden("lambert", {})), 4096, catalog());
    ASSERT_TRUE(target);
    const std::vector<Material> many(1000, hidden("he-torrance", {}));
    const ModelMatches matches = fittedMaterials(many, *target, {}, catalog(),
                                                 [](double, const ModelMatches&) { return false; });
    EXPECT_LT(matches.rows.size(), 10u);
    EXPECT_TRUE(matches.problems.empty());
    EXPECT_TRUE(std::ranges::all_of(matches.rows, &ModelMatch::isStopped));
}

TEST(Matched, SurfaceMeasuredAtGrazingAnglesAlone_IsAnError) {
    const TemporaryFolder folder;
    writeFile(folder / "a.binary", merlBytes({30, 30, 60}, [](const DirectionPair& pair) {
                  return glm::dvec3(pair.l.z < 0.1 ? 0.2 : -1.0);
              }));
    const auto aim = readMatchAim(folder / "a.binary", catalog(), 256);
    ASSERT_FALSE(aim);
    EXPECT_NE(text(aim.error()).find("80 degrees"), std::string::npos);
}

TEST(Matched, DirectionsOfALitBall_CountAsOneEach) {
    const auto target = matchTarget(*sweepVariant(catalog(), hidden("lambert", {})), 400, catalog(),
                                    MatchDirections::LitBall);
    ASSERT_TRUE(target);
    ASSERT_EQ(target->weights.size(), 400u);
    EXPECT_NEAR(std::accumulate(target->weights.begin(), target->weights.end(), 0.0), 400.0, 25.0);
    EXPECT_EQ(target->first(10).weights.size(), 10u);
    const auto inTheMiddle = std::ranges::count_if(
        target->pairs, [](const DirectionPair& pair) { return pair.v.z > std::sqrt(0.75); });
    EXPECT_GT(inTheMiddle, 80) << "a fourth of the ball's picture";
}

/// Lightness asks for the colour of a surface, and light for its highlight.
TEST(Matched, Lightness_KeepsABodysColourUnderAHighlightThatCannotBeHad) {
    const auto target = matchTarget(
        *sweepVariant(catalog(), hidden("phong", {{"diffuse.color", glm::dvec3(0.4, 0.05, 0.05)},
                                                  {"specular.color", glm::dvec3(1.0)},
                                                  {"shininess", 400.0}})),
        512, catalog(), MatchDirections::LitBall);
    ASSERT_TRUE(target);
    const ModelMatches matches =
        fittedMaterials({hidden("lambert", {})}, *target, {.error = MatchError::Lightness},
                        catalog(), [](double, const ModelMatches&) { return true; });
    ASSERT_EQ(matches.rows.size(), 1u);
    const auto color =
        std::get<glm::dvec3>(matches.rows.front().material.model.parameters.at("diffuse.color"));
    EXPECT_NEAR(color.r, 0.4, 0.1);
    EXPECT_NEAR(color.g, 0.05, 0.05);
}

TEST(Matched, Drawings_AreNoReflectances) {
    const Material drawing = hidden("gooch", {});
    EXPECT_FALSE(matchAim(drawing, catalog(), 64));
    const auto target = matchTarget(*sweepVariant(catalog(), hidden("lambert", {})), 64, catalog());
    ASSERT_TRUE(target);
    EXPECT_EQ(fittedMaterials({drawing}, *target, {}, catalog(),
                              [](double, const ModelMatches&) { return true; })
                  .problems.size(),
              1u);
    for (const Block* model : matchedModels(catalog())) {
        EXPECT_EQ(model->lighting, LightsWanted::All) << model->id;
    }
    EXPECT_GE(matchedModels(catalog()).size(), 15u);
}

TEST(Matched, QuickestWithin_IsTheQuickestThatIsNearEnough) {
    ModelMatches matches;
    const auto row = [](const char* id, double relative) {
        ModelMatch match;
        match.material.model.id = id;
        match.error = relative;
        match.relative = relative;
        return match;
    };
    matches.rows = {row("a", 0.01), row("b", 0.018), row("c", 0.019), row("d", 0.5)};
    EXPECT_EQ(quickestWithin(matches, 0.02), nullptr);
    addTimes(matches, {{"a", 9.0}, {"b", 4.0}, {"c", 5.0}, {"d", 1.0}});
    ASSERT_NE(quickestWithin(matches, 0.02), nullptr);
    EXPECT_EQ(quickestWithin(matches, 0.02)->material.model.id, "b");
    EXPECT_EQ(quickestWithin(matches, 0.001), nullptr);
    EXPECT_TRUE(matches.rows[0].isOnFront && matches.rows[1].isOnFront);
    EXPECT_FALSE(matches.rows[2].isOnFront);
    EXPECT_TRUE(matches.rows[3].isOnFront);
}

} // namespace
} // namespace patina::match_test
