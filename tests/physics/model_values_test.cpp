// SPDX-License-Identifier: GPL-3.0-or-later
// Models and highlights against published formulas, from a table and from a second form.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "catalog/curve.h"
#include "catalog/ramp.h"
#include "catalog/value_json.h"
#include "measure/stability/hemisphere_rule.h"
#include "physics_cases.h"

namespace patina::physics::model_values_test {
namespace {

/// The table has 15 digits of each value; a value near 0 is the difference of terms near 1.
constexpr double relativeRounding = 1e-12;
constexpr double absoluteRounding = 2e-15;

Values valuesFrom(const Block& block, const nlohmann::json& json) {
    Values values;
    for (const auto& [id, value] : json.items()) {
        values.emplace(id, valueFromJson(*block.parameter(id), value).value());
    }
    return values;
}

reference::Geometry placed(const nlohmann::json& pair) {
    return geometry(direction(pair["light"][0], pair["light"][1]),
                    direction(pair["viewer"][0], pair["viewer"][1]));
}

class ModelTable : public testing::TestWithParam<nlohmann::json> {};

TEST_P(ModelTable, SixPairsOfDirections_MatchTheFormula) {
    const nlohmann::json& row = GetParam();
    const Block* block =
        catalog().find(row["kind"].get<std::string>(), row["id"].get<std::string>());
    ASSERT_NE(block, nullptr);
    const Subject subject(block->kind, block->id, valuesFrom(*block, row["parameters"]));
    for (const auto& [name, pair] : table("models.json")["directions"].items()) {
        const double expected = row["values"][name];
        EXPECT_NEAR(subject.shade(placed(pair)).x, expected,
                    relativeRounding * expected + absoluteRounding * (expected > 1e-3))
            << name;
    }
}

INSTANTIATE_TEST_SUITE_P(EveryRow, ModelTable, testing::ValuesIn(table("models.json")["rows"]),
                         [](const auto& row) {
                             return row.param["name"].template get<std::string>();
                         });

/// Directions all over the hemisphere.
std::vector<reference::Geometry> manyPairs() {
    std::vector<reference::Geometry> pairs;
    for (const double l : {3.0, 25.0, 50.0, 70.0, 88.0}) {
        for (const double v : {1.0, 33.0, 60.0, 85.0}) {
            for (const double phi : {0.0, 40.0, 100.0, 150.0, 180.0}) {
                pairs.push_back(geometry(direction(l, 10.0), direction(v, 10.0 + phi)));
            }
        }
    }
    return pairs;
}

Subject orenNayar(const std::string& form, double roughness, double albedo) {
    return Subject(
        "models", "oren-nayar",
        {{"diffuse.color", glm::dvec3(albedo)}, {"roughness", roughness}, {"form", form}});
}

/// The albedo of one bounce of Fujii's model, from acos as the paper of EON prints it (equation
/// 14).
double oneBounceAlbedo(double c, double r) {
    const double pi = std::numbers::pi;
    const double A = 1.0 / (1.0 + (0.5 - 2.0 / (3.0 * pi)) * r);
    const double s = std::sqrt(1.0 - c * c);
    const double G = s * (std::acos(c) - s * c) + 2.0 / 3.0 * (s / c * (1.0 - s * s * s) - s);
    return A * (1.0 + r / pi * G);
}

double fujii(const reference::Geometry& g, double r) {
    const double s = glm::dot(g.l, g.v) - g.l.z * g.v.z;
    const double A = 1.0 / (1.0 + (0.5 - 2.0 / (3.0 * std::numbers::pi)) * r);
    return g.l.z * A * (1.0 + r * s / (s > 0.0 ? std::max(g.l.z, g.v.z) : 1.0));
}

TEST(OrenNayar, Fujii_MatchesItsPrintedForm) {
    const Subject model = orenNayar("fujii", 0.7, 1.0);
    for (const auto& g : manyPairs()) {
        EXPECT_NEAR(model.shade(g).x, fujii(g, 0.7), 1e-13);
    }
}

TEST(OrenNayar, Eon_MatchesItsPrintedForm) {
    const double pi = std::numbers::pi;
    const double r = 0.7;
    const double rho = 0.6;
    const double A = 1.0 / (1.0 + (0.5 - 2.0 / (3.0 * pi)) * r);
    const double average = A * (1.0 + (2.0 / 3.0 - 28.0 / (15.0 * pi)) * r);
    const double bounced = rho * rho * average / (1.0 - rho * (1.0 - average));
    const Subject model = orenNayar("eon", r, rho);
    for (const auto& g : manyPairs()) {
        const double more = bounced * (1.0 - oneBounceAlbedo(g.l.z, r)) *
                            (1.0 - oneBounceAlbedo(g.v.z, r)) / (1.0 - average) * g.l.z;
        EXPECT_NEAR(model.shade(g).x, rho * fujii(g, r) + more, 1e-12);
    }
}

/// The integral of f (n.v) over the hemisphere, by the midpoint rule in cos^2 and azimuth.
double albedo(const Subject& model, double lightDegrees) {
    constexpr int rings = 200;
    constexpr int sectors = 200;
    double sum = 0.0;
    for (int ring = 0; ring < rings; ++ring) {
        const double theta = std::acos(std::sqrt((ring + 0.5) / rings)) * 180.0 / std::numbers::pi;
        for (int sector = 0; sector < sectors; ++sector) {
            const double phi = 360.0 * (sector + 0.5) / sectors;
            sum += model.shade(geometry(direction(lightDegrees, 0), direction(theta, phi))).x;
        }
    }
    return sum / (rings * sectors) / std::cos(lightDegrees * std::numbers::pi / 180.0);
}

TEST(OrenNayar, WhiteEon_GivesBackAllTheLight) {
    for (const double degrees : {0.0, 45.0, 80.0}) {
        EXPECT_NEAR(albedo(orenNayar("eon", 0.8, 1.0), degrees), 1.0, 2e-4) << degrees;
    }
}

TEST(OrenNayar, Smooth_IsLambert) {
    for (const char* form :
         {"qualitative-033", "qualitative-057", "full", "interreflection", "fujii", "eon"}) {
        for (const auto& g : manyPairs()) {
            EXPECT_NEAR(orenNayar(form, 0.0, 0.5).shade(g).x, 0.5 * g.l.z, 1e-15) << form;
        }
    }
}

TEST(Minnaert, DarkeningOne_IsLambert) {
    const Subject model("models", "minnaert", {{"diffuse.color", white}, {"darkening", 1.0}});
    for (const auto& g : manyPairs()) {
        EXPECT_NEAR(model.shade(g).x, g.l.z, 1e-15);
    }
}

TEST(Minnaert, Normalised_HasTheSameAlbedoAtTheNormal) {
    for (const double darkening : {0.7, 1.5, 2.0}) {
        const Subject model("models", "minnaert",
                            {{"diffuse.color", white},
                             {"darkening", darkening},
                             {"normalisation", std::string("normalised")}});
        EXPECT_NEAR(albedo(model, 0.0), 1.0, 2e-3) << darkening;
    }
}

TEST(LommelSeeliger, LightBehindTheViewer_IsAFlatDisc) {
    const Subject model("models", "lommel-seeliger", {{"diffuse.color", white}});
    for (const double degrees : {0.0, 30.0, 60.0, 89.0}) {
        EXPECT_NEAR(model.shade(geometry(direction(degrees, 5), direction(degrees, 5))).x, 0.5,
                    1e-15);
    }
}

TEST(Gooch, TwoLights_NeverDarkenTheMean) {
    const Subject model("models", "gooch", {{"lights", std::string("two")}});
    const Subject mean("models", "gooch", {{"lights", std::string("one")}});
    const glm::dvec3 halfWay = mean.shade(geometry(direction(90, 0), direction(0, 0)));
    for (const double degrees : {0.0, 60.0, 120.0, 180.0}) {
        const glm::dvec3 value = model.shade(geometry(direction(degrees, 0), direction(10, 0)));
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_GE(value[channel], halfWay[channel] - 1e-15) << degrees;
        }
    }
}

Subject goochAmbient(const std::string& rule) {
    return Subject("models", "gooch",
                   {{"diffuse.color", white},
                    {"warm.color", glm::dvec3(0.3)},
                    {"cool.color", glm::dvec3(0.1)},
                    {"warm.mix", 0.5},
                    {"cool.mix", 0.25},
                    {"ambient.rule", rule},
                    {"ambient.color", glm::dvec3(0.05)},
                    {"ambient.amount", 1.0}});
}

TEST(Gooch, AmbientRules_AddTheirTone) {
    const auto g = geometry(direction(30, 0), direction(20, 90));
    const double u = 0.5 * (1.0 + g.l.z);
    const double tone = u * 0.8 + (1.0 - u) * 0.35;
    EXPECT_NEAR(goochAmbient("color").shade(g).x, tone + 0.05, 1e-15);
    EXPECT_NEAR(goochAmbient("raw").shade(g).x, tone + 0.2, 1e-15);
    EXPECT_NEAR(goochAmbient("mixed").shade(g).x, tone + 0.575, 1e-15);
}

glm::dvec3 toon(double lightDegrees, const std::string& tones) {
    const Subject model("models", "toon",
                        {{"diffuse.color", glm::dvec3(0.5)},
                         {"shadow.color", glm::dvec3(0.1)},
                         {"bright.color", glm::dvec3(0.9)},
                         {"specular.color", black},
                         {"tones", tones},
                         {"softness", 0.02}});
    return model.shade(geometry(direction(lightDegrees, 0), direction(5, 90)));
}

TEST(Toon, TwoTones_AreFlat) {
    EXPECT_EQ(toon(10, "two").x, 0.5);
    EXPECT_EQ(toon(60, "two").x, 0.5);
    EXPECT_EQ(toon(85, "two").x, 0.1);
    EXPECT_EQ(toon(130, "two").x, 0.1);
}

TEST(Toon, ThreeTones_AreFlat) {
    EXPECT_EQ(toon(10, "three").x, 0.9);
    EXPECT_EQ(toon(60, "three").x, 0.5);
    EXPECT_EQ(toon(130, "three").x, 0.1);
}

/// The tone of a Gooch surface that is black on the cool side and white on the warm one.
double goochShare(const Value& curve, double lightDegrees) {
    const Subject model("models", "gooch",
                        {{"diffuse.color", black},
                         {"warm.color", white},
                         {"cool.color", black},
                         {"tone.curve", curve}});
    return model.shade(geometry(direction(lightDegrees, 0), direction(5, 90))).x;
}

TEST(Gooch, ToneResponse_IsTheCurve) {
    for (const CurvePoints& points :
         {CurvePoints{{0.0, 0.1}, {0.3, 0.2}, {0.31, 0.8}, {0.9, 0.9}},
          CurvePoints{{0.2, 1.0}, {0.5, 0.0}, {1.0, 0.7}}, curvePresets()[2].points}) {
        const CurveShape shape(points);
        for (double degrees = 0.0; degrees <= 180.0; degrees += 1.0) {
            const double u = 0.5 * (1.0 + std::cos(degrees * std::numbers::pi / 180.0));
            EXPECT_NEAR(goochShare(curveValue(points), degrees), shape.at(u), 1e-12) << degrees;
        }
    }
}

TEST(Gooch, LinearResponse_IsTheModelWithoutOne) {
    for (const CurvePoints& points :
         {CurvePoints{{0.0, 0.0}, {1.0, 1.0}}, CurvePoints{{0.0, 0.0}, {0.25, 0.25}, {1.0, 1.0}}}) {
        for (double degrees = 0.0; degrees <= 180.0; degrees += 10.0) {
            EXPECT_NEAR(goochShare(curveValue(points), degrees),
                        0.5 * (1.0 + std::cos(degrees * std::numbers::pi / 180.0)), 1e-15);
        }
    }
}

TEST(Toon, RampOfTones_IsTheRamp) {
    for (const auto interpolation :
         {RampInterpolation::Linear, RampInterpolation::Smooth, RampInterpolation::Constant}) {
        const Ramp ramp{interpolation, {{0.1, black}, {0.4, {0.8, 0.2, 0.1}}, {0.9, white}}};
        const Subject model("models", "toon",
                            {{"tones", std::string("ramp")},
                             {"specular.color", black},
                             {"tone.ramp", rampValue(ramp)}});
        for (double degrees = 0.0; degrees <= 120.0; degrees += 1.0) {
            const glm::dvec3 value = model.shade(geometry(direction(degrees, 0), direction(5, 90)));
            const glm::dvec3 wanted = ramp.at(std::cos(degrees * std::numbers::pi / 180.0));
            EXPECT_NEAR(glm::distance(value, wanted), 0.0, 1e-9) << degrees;
        }
    }
}

/// The default ramp says what the default colours and edges say.
TEST(Toon, DefaultRamp_IsTheThreeTones) {
    const Subject ramp("models", "toon", {{"tones", std::string("ramp")}});
    const Subject three("models", "toon", {{"tones", std::string("three")}});
    for (double degrees = 0.0; degrees <= 180.0; degrees += 0.25) {
        const auto g = geometry(direction(degrees, 0), direction(5, 90));
        EXPECT_NEAR(glm::distance(ramp.shade(g), three.shade(g)), 0.0, 1e-9) << degrees;
    }
}

TEST(Toon, Spot_EndsAtItsSize) {
    const Subject model("models", "toon",
                        {{"diffuse.color", black},
                         {"shadow.color", black},
                         {"specular.color", white},
                         {"spot.size", 20.0},
                         {"softness", 0.001}});
    EXPECT_EQ(model.shade(geometry(direction(30, 0), direction(31, 180))).x, 1.0);
    EXPECT_EQ(model.shade(geometry(direction(30, 0), direction(49, 180))).x, 1.0);
    EXPECT_EQ(model.shade(geometry(direction(30, 0), direction(51, 180))).x, 0.0);
}

double blinnBehind(const std::string& gating) {
    const Subject model("models", "blinn-phong", {{"specular.color", white}, {"gating", gating}});
    return model.shade(geometry(direction(95, 0), direction(60, 180))).x;
}

TEST(BlinnPhong, LightBehindTheSurface_ShinesByThePowerAlone) {
    EXPECT_EQ(blinnBehind("lit"), 0.0);
    EXPECT_GT(blinnBehind("power"), 0.0);
}

TEST(Strauss, MicrofacetLobes_AreAsBrightInTheMiddle) {
    const auto g = geometry(direction(35, 0), direction(35, 180));
    const double own = Subject("models", "strauss", {{"smoothness", 0.8}}).shade(g).x;
    for (const char* lobe : {"beckmann", "ggx"}) {
        const Subject model("models", "strauss",
                            {{"smoothness", 0.8}, {"lobe", std::string(lobe)}});
        EXPECT_NEAR(model.shade(g).x, own, 1e-12) << lobe;
    }
}

/// A white metal of the smoothness, with or without its highlight.
Subject straussMetal(double smoothness, const std::string& strength, double gloss) {
    return Subject("models", "strauss",
                   {{"diffuse.color", white},
                    {"metalness", 1.0},
                    {"smoothness", smoothness},
                    {"normalisation", strength},
                    {"gloss", gloss}});
}

/// (e + 1) / 2 times as bright with e = 3 / (1 - s).
TEST(Strauss, SameEnergy_ScalesTheHighlightAlone) {
    const auto g = geometry(direction(35, 0), direction(38, 180));
    for (const double smoothness : {0.0, 0.5, 0.95}) {
        const double matte = straussMetal(smoothness, "raw", 0.0).shade(g).x;
        const double raw = straussMetal(smoothness, "raw", 1.0).shade(g).x - matte;
        const double strong = straussMetal(smoothness, "normalised", 1.0).shade(g).x - matte;
        EXPECT_NEAR(strong, 0.5 * (3.0 / (1.0 - smoothness) + 1.0) * raw, 1e-12);
    }
}

/// Of light from all around a metal that faces the viewer mirrors s^3, where its highlight is too
/// narrow to reach the horizon.
TEST(Strauss, SameEnergy_MirrorsItsShareOfAnEvenSky) {
    for (const double smoothness : {0.9, 0.95, 0.98}) {
        const Subject matte = straussMetal(smoothness, "normalised", 0.0);
        const Subject metal = straussMetal(smoothness, "normalised", 1.0);
        const glm::dvec3 v{0.0, 0.0, 1.0};
        double sum = 0.0;
        for (const WeightedDirection& from : hemisphereRule(v)) {
            const auto g = geometry(from.v, v);
            sum += from.weight * (metal.shade(g).x - matte.shade(g).x);
        }
        EXPECT_NEAR(sum, smoothness * smoothness * smoothness, 0.02) << smoothness;
    }
}

TEST(SpecularSlot, Filled_AddsItsHighlight) {
    const Subject highlight("specular", "phong", {{"specular.color", glm::dvec3(0.3)}});
    for (const char* id : {"lambert", "oren-nayar", "minnaert", "lommel-seeliger", "gooch"}) {
        const Subject model("models", id);
        for (const auto& g : manyPairs()) {
            EXPECT_NEAR(model.shade(g, highlight.filler()).x,
                        model.shade(g).x + highlight.shade(g).x, 1e-14)
                << id;
        }
    }
}

TEST(SpecularSlot, Limited_HasAPlateau) {
    const Subject lobe(
        "specular", "blinn-phong",
        {{"specular.color", white}, {"gloss", 0.25}, {"gloss.mode", std::string("limit")}});
    EXPECT_EQ(lobe.shade(geometry(direction(30, 0), direction(30, 180))).x, 0.25);
}

} // namespace
} // namespace patina::physics::model_values_test
