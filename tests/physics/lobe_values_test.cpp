// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "direction_pairs.h"

namespace patina::physics::lobe_values_test {
namespace {

TEST(Directions, SixPairs_MatchTheirDotProducts) {
    const auto data = table("lobes.json")["projections"];
    const std::map<std::string, Projection> names{{"nl", nl}, {"nv", nv}, {"nh", nh},
                                                  {"lh", lh}, {"rv", rv}, {"lv", lv}};
    for (const auto& [name, index] : names) {
        expectRow(data[name],
                  [place = index](const reference::Geometry& g) { return projections(g)[place]; });
    }
}

TEST(Phong, ItsLobe_MatchesThePower) {
    const auto lobes = table("lobes.json")["lobes"];
    for (const auto& lobe : lobes) {
        const std::string id = lobe["lobe"] == "(r.v)^e" ? "phong" : "blinn-phong";
        const Subject model("models", id,
                            {{"diffuse.color", black},
                             {"specular.color", white},
                             {"shininess", lobe["e"].get<double>()}});
        expectRow(lobe["values"], [&](const reference::Geometry& g) { return model.shade(g).x; });
    }
}

/// Is a block with a reciprocal form, and its values of a highlight without a matte base.
struct Highlight {
    std::string kind;
    std::string id;
    Values values;

    Subject of(const std::string& form, const std::string& gloss = "multiply") const {
        Values chosen = values;
        chosen["specular.color"] = glm::dvec3(0.7);
        chosen["highlight.form"] = form;
        chosen["gloss"] = 0.6;
        chosen["gloss.mode"] = gloss;
        return Subject(kind, id, chosen);
    }
};

/// Returns all that have one.
std::vector<Highlight> highlightsOfTwoForms() {
    return {{"models", "schlick", {{"diffuse.color", black}, {"shininess", 20.0}}},
            {"specular", "schlick", {{"shininess", 20.0}}},
            {"models", "gaussian", {{"diffuse.color", black}, {"width", 0.4}}},
            {"specular", "gaussian", {{"width", 0.4}}}};
}

/// What arrives is n.l, so that f is the value over it.
TEST(ReciprocalForm, LightAndViewerExchanged_IsTheSame) {
    for (const Highlight& highlight : highlightsOfTwoForms()) {
        for (const std::string gloss : {"multiply", "limit"}) {
            const Subject reciprocal = highlight.of("reciprocal", gloss);
            for (const std::string name : {"A", "B", "D", "E", "F"}) {
                const auto g = pairOfDirections(name);
                const double there = reciprocal.shade(g).x / g.l.z;
                const double back = reciprocal.shade(geometry(g.v, g.l)).x / g.v.z;
                EXPECT_NEAR(there, back, 1e-13 * there)
                    << highlight.kind << highlight.id << gloss << name;
            }
        }
    }
}

TEST(ReciprocalForm, OfEachLobe_IsThePublishedOneTimesTheCosine) {
    for (const Highlight& highlight : highlightsOfTwoForms()) {
        for (const std::string name : {"A", "B", "C", "D", "E", "F"}) {
            const auto g = pairOfDirections(name);
            const double published = highlight.of("raw").shade(g).x;
            EXPECT_NEAR(highlight.of("reciprocal").shade(g).x, g.l.z * published, 1e-14)
                << highlight.kind << highlight.id << name;
        }
    }
}

TEST(PublishedForm, WithoutAChoice_IsTheLobeAlone) {
    const auto lobe = [](const char* id, const Values& values) {
        Values chosen = values;
        chosen["diffuse.color"] = black;
        chosen["specular.color"] = white;
        return Subject("models", id, chosen);
    };
    const Subject schlick = lobe("schlick", {{"shininess", 25.0}});
    const Subject gaussian = lobe("gaussian", {{"width", 0.5}});
    for (const std::string name : {"A", "B", "C", "D", "E", "F"}) {
        const auto g = pairOfDirections(name);
        const double t = projections(g)[rv];
        EXPECT_NEAR(schlick.shade(g).x, t > 0.0 ? t / (25.0 - 25.0 * t + t) : 0.0, 1e-14) << name;
        const double angle = std::acos(projections(g)[nh]);
        EXPECT_NEAR(gaussian.shade(g).x, std::exp(-4.0 * angle * angle), 1e-13) << name;
    }
}

TEST(Lambert, White_IsTheCosine) {
    const Subject model("models", "lambert", {{"diffuse.color", white}});
    expectRow(table("lobes.json")["projections"]["nl"],
              [&](const reference::Geometry& g) { return model.shade(g).x; });
}

TEST(BeckmannDistribution, Table_Matches) {
    const auto data = table("lobes.json")["beckmann"];
    expectRow(data["values"], [&](const reference::Geometry& g) {
        const auto p = projections(g);
        return call("beckmann_distribution", {p[sin2h], p[cos2h], data["alpha"]})[0];
    });
}

TEST(GgxDistribution, Table_Matches) {
    const auto data = table("lobes.json")["ggx"];
    expectRow(data["values"], [&](const reference::Geometry& g) {
        const auto p = projections(g);
        return call("ggx_distribution", {p[sin2h], p[cos2h], data["alpha"]})[0];
    });
}

TEST(VCavityMasking, Table_Matches) {
    expectRow(table("lobes.json")["vCavity"]["values"], [&](const reference::Geometry& g) {
        const auto p = projections(g);
        return 4.0 * p[nv] * call("v_cavity_visibility", {p[nl], p[nv], p[nH], p[HH]})[0];
    });
}

/// The integral of D cos over the hemisphere, by the midpoint rule in u = tan^2 / (1 + tan^2).
double cosineIntegral(const std::string& distribution, double alpha) {
    constexpr int steps = 200000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        // sin^2 = s^4 puts most samples into the narrow lobe; cos sin dtheta = d(sin^2) / 2.
        const double s = (i + 0.5) / steps;
        const double sin2 = s * s * s * s;
        sum += call(distribution, {sin2, 1.0 - sin2, alpha})[0] * 2.0 * s * s * s / steps;
    }
    return 2.0 * std::numbers::pi * sum;
}

TEST(MicrofacetDistributions, IntegratedOverTheHemisphere_GiveOne) {
    for (const char* distribution : {"beckmannDistribution", "ggxDistribution"}) {
        for (const double alpha : {0.02, 0.1, 0.3, 1.0}) {
            EXPECT_NEAR(cosineIntegral(distribution, alpha), 1.0, 1e-6) << distribution << alpha;
        }
    }
}

Subject cookTorrance(const std::string& scale) {
    return Subject("models", "cook-torrance",
                   {{"diffuse.color", black},
                    {"specular.color", white},
                    {"roughness", 0.3},
                    {"distribution", std::string("beckmann")},
                    {"scale", scale}});
}

void expectMicrofacetBrdf(const std::string& scale, const std::string& column) {
    const Subject fresnel("fresnel", "schlick", {{"f0", glm::dvec3(0.04)}});
    const Subject model = cookTorrance(scale);
    expectRow(table("lobes.json")["microfacet"][column], [&](const reference::Geometry& g) {
        return model.shade(g, fresnel.filler()).x / (std::numbers::pi * g.l.z);
    });
}

TEST(CookTorrance, Normalised_MatchesItsBrdf) {
    expectMicrofacetBrdf("normalised", "normalised");
}

TEST(CookTorrance, PrintedScale_MatchesItsBrdf) {
    expectMicrofacetBrdf("1982", "printed");
}

Subject strauss(const nlohmann::json& set, const std::string& argument, double color,
                double highlight) {
    return Subject("models", "strauss",
                   {{"diffuse.color", glm::dvec3(color)},
                    {"specular.color", glm::dvec3(highlight)},
                    {"metalness", set["metalness"].get<double>()},
                    {"smoothness", set["smoothness"].get<double>()},
                    {"argument", argument}});
}

void expectStrauss(const std::string& argument) {
    for (const auto& set : table("lobes.json")["strauss"]["sets"]) {
        const Subject model = strauss(set, argument, 0.8, 1.0);
        for (const auto& [name, highlight] : set[argument].items()) {
            const double expected = highlight.get<double>() + set["matte"][name].get<double>();
            EXPECT_NEAR(model.shade(pairOfDirections(name)).x, expected, 1e-13) << name;
        }
    }
}

TEST(Strauss, ByAngle_MatchesItsTable) {
    expectStrauss("angle");
}

TEST(Strauss, ByCosine_MatchesItsTable) {
    expectStrauss("cosine");
}

TEST(Strauss, PerfectMirror_ShinesOnlyInTheMirrorDirection) {
    const Subject model("models", "strauss",
                        {{"diffuse.color", white}, {"metalness", 1.0}, {"smoothness", 1.0}});
    EXPECT_GT(model.shade(geometry(direction(0, 0), direction(0, 0))).x, 0.9);
    EXPECT_EQ(model.shade(geometry(direction(40, 0), direction(41, 180))).x, 0.0);
}

} // namespace
} // namespace patina::physics::lobe_values_test
