// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <gtest/gtest.h>

#include "direction_pairs.h"

namespace patina::physics::microfacet_values_test {
namespace {

const nlohmann::json& numbers() {
    static const nlohmann::json data = table("microfacet.json");
    return data;
}

/// A term of one cosine and one width.
void expectTerm(const std::string& function, double width, const nlohmann::json& row) {
    expectRow(row, [&](const reference::Geometry& g) {
        return call(function, {projections(g)[nh], width})[0];
    });
}

const double halfWidth = numbers()["halfWidthDegrees"].get<double>() * std::numbers::pi / 180.0;

TEST(PrintedTerms, TorranceSparrowD_MatchesItsTable) {
    expectTerm("torrance_sparrow_d", halfWidth, numbers()["torranceSparrow"]);
}

TEST(PrintedTerms, PhongD_MatchesItsTable) {
    expectTerm("phong_d", halfWidth, numbers()["phong"]);
}

TEST(PrintedTerms, TrowbridgeReitzD_MatchesItsTable) {
    expectTerm("trowbridge_reitz_d", numbers()["c3"], numbers()["trowbridgeReitzByC3"]);
}

TEST(PrintedTerms, TrowbridgeReitzD_TakesItsWidthFromTheHalfAngle) {
    const double c3 = call("trowbridge_reitz_width", {halfWidth})[0];
    expectTerm("trowbridge_reitz_d", c3, numbers()["trowbridgeReitz"]);
}

TEST(PrintedTerms, GaussianD_MatchesItsTable) {
    expectTerm("gaussian_d", numbers()["m"], numbers()["gaussian"]);
}

TEST(PrintedTerms, BlinnD_MatchesTheNormalisedPower) {
    expectTerm("blinn_d", numbers()["exponent"], numbers()["blinn"]);
}

TEST(PrintedTerms, BeckmannD_MatchesItsTable) {
    const auto data = table("lobes.json")["beckmann"];
    expectTerm("beckmann_d", data["alpha"], data["values"]);
}

TEST(PrintedTerms, GgxD_MatchesItsTable) {
    const auto data = table("lobes.json")["ggx"];
    expectTerm("ggx_d", data["alpha"], data["values"]);
}

TEST(PrintedTerms, VCavityG_MatchesItsTable) {
    expectRow(table("lobes.json")["vCavity"]["values"], [](const reference::Geometry& g) {
        const auto p = projections(g);
        return call("v_cavity_g", {p[nl], p[nv], p[nh], p[lh]})[0];
    });
}

TEST(PrintedTerms, SmithG1_MatchesItsTable) {
    for (const auto& row : numbers()["smithG1"]) {
        for (const std::string profile : {"beckmann", "ggx"}) {
            const double expected = row[profile];
            EXPECT_NEAR(call("smith_" + profile + "_g1", {row["cosine"], row["alpha"]})[0],
                        expected, 1e-14)
                << row;
        }
    }
}

TEST(PrintedTerms, BelowTheHorizon_AreZero) {
    for (const char* function : {"beckmann_d", "blinn_d", "phong_d", "smith_ggx_g1"}) {
        EXPECT_EQ(call(function, {-0.5, 0.3})[0], 0.0) << function;
    }
}

/// Cook-Torrance as a mirror of reflectance 1.
Subject mirror(const std::string& distribution, const std::string& masking,
               const std::string& scale) {
    return Subject("models", "cook-torrance",
                   {{"diffuse.color", black},
                    {"specular.color", white},
                    {"roughness", numbers()["roughness"].get<double>()},
                    {"distribution", distribution},
                    {"masking", masking},
                    {"scale", scale}});
}

constexpr reference::BlockCall reflectsAll{
    "", 2, 3, [](const double*, double* out, reference::Parameters) { std::fill_n(out, 3, 1.0); }};
constexpr reference::BlockCall tellsIncidence{
    "", 2, 3, [](const double* in, double* out, reference::Parameters) {
        out[0] = in[0];
        out[1] = in[1];
        out[2] = 1.0;
    }};

reference::Block fresnelWith(const reference::BlockCall& call) {
    reference::Block block;
    block.kind = "fresnel";
    block.calls = {&call, 1};
    return block;
}

const reference::Block whiteMirror = fresnelWith(reflectsAll);
const reference::Filler reflectingAll{&whiteMirror, {}};

TEST(CookTorrance, EveryDistributionWithEveryMasking_MatchesItsTable) {
    for (const auto& [names, row] : numbers()["model"].items()) {
        const auto space = names.find(' ');
        const Subject model = mirror(names.substr(0, space), names.substr(space + 1), "normalised");
        SCOPED_TRACE(names);
        expectRow(row,
                  [&](const reference::Geometry& g) { return model.shade(g, reflectingAll).x; });
    }
}

TEST(CookTorrance, EveryDistributionAtThePrintedScale_MatchesItsTable) {
    for (const auto& [distribution, row] : numbers()["printed"].items()) {
        const Subject model = mirror(distribution, "v-cavity", "1982");
        SCOPED_TRACE(distribution);
        expectRow(row,
                  [&](const reference::Geometry& g) { return model.shade(g, reflectingAll).x; });
    }
}

/// The cosine at which the model asks for the reflectance: the channels tell what it was.
double askedCosine(const std::string& choice, const reference::Geometry& g) {
    const reference::Block telling = fresnelWith(tellsIncidence);
    const Subject model("models", "cook-torrance",
                        {{"diffuse.color", black}, {"fresnel.cosine", choice}});
    const glm::dvec3 value = model.shade(g, {&telling, {}});
    EXPECT_NEAR(value.y / value.z, 1.0 - value.x / value.z, 1e-14);
    return value.x / value.z;
}

TEST(CookTorrance, FresnelCosine_IsTheChosenOne) {
    const reference::Geometry g = pairOfDirections("A");
    EXPECT_NEAR(askedCosine("half", g), projections(g)[lh], 1e-14);
    EXPECT_NEAR(askedCosine("light", g), projections(g)[nl], 1e-14);
    EXPECT_NEAR(askedCosine("view", g), projections(g)[nv], 1e-14);
}

TEST(CookTorrance, WithTheHalfAnglesFresnel_IsReciprocal) {
    for (const std::string masking : {"v-cavity", "smith", "smith-correlated", "schlick-smith"}) {
        const Subject model = mirror("ggx", masking, "normalised");
        for (const std::string name : {"A", "B", "D", "E", "F"}) {
            const reference::Geometry g = pairOfDirections(name);
            const double there = model.shade(g, reflectingAll).x / g.l.z;
            const double back = model.shade(geometry(g.v, g.l), reflectingAll).x / g.v.z;
            EXPECT_NEAR(there, back, 1e-13 * there) << masking << name;
        }
    }
}

TEST(CookTorrance, GaussianConstant_ScalesThePrintedGaussian) {
    const Values printed{{"diffuse.color", black},
                         {"distribution", std::string("blinn-gaussian")},
                         {"scale", std::string("1982")}};
    Values doubled = printed;
    doubled["gaussian.constant"] = 2.0;
    const auto g = pairOfDirections("A");
    EXPECT_NEAR(Subject("models", "cook-torrance", doubled).shade(g, reflectingAll).x,
                2.0 * Subject("models", "cook-torrance", printed).shade(g, reflectingAll).x, 1e-14);
}

TEST(MetallicRoughness, Brdf_IsThatOfGltf) {
    for (const auto& data : numbers()["metallicRoughness"]) {
        const Subject model("models", "metallic-roughness",
                            {{"diffuse.color", glm::dvec3(data["base"].get<double>())},
                             {"metalness", data["metalness"].get<double>()},
                             {"roughness", data["roughness"].get<double>()},
                             {"f0", glm::dvec3(data["f0"].get<double>())}});
        expectRow(data["values"], [&](const reference::Geometry& g) {
            return model.shade(g).x / (std::numbers::pi * g.l.z);
        });
    }
}

} // namespace
} // namespace patina::physics::microfacet_values_test
