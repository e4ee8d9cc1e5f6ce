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
