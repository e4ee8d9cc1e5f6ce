// SPDX-License-Identifier: GPL-3.0-or-later
// Where a formula as printed has no value, models take its limit or a floor that is documented.
#include <gtest/gtest.h>

#include "physics_cases.h"

namespace patina::physics::limits_test {
namespace {

/// A row of model, values and the ids of what goes to its end.
struct Lobe {
    const char* kind;
    const char* model;
    Values values;
    std::vector<std::string> ends;
};

Subject at(Lobe lobe, double end) {
    for (const std::string& id : lobe.ends) {
        const bool vector =
            catalog().find(lobe.kind, lobe.model)->parameter(id)->type == ParameterType::Vec3;
        lobe.values[id] = vector ? Value(glm::dvec3(end)) : Value(end);
    }
    return Subject(lobe.kind, lobe.model, lobe.values);
}

double shaded(const Subject& model, const reference::Geometry& g) {
    static const Subject half = schlickFrom(0.5);
    return model.shade(g, half.filler()).x;
}

const reference::Geometry mirrored = geometry(direction(40, 10), direction(40, 190));
const reference::Geometry elsewhere = geometry(direction(30, 0), direction(60, 70));
const reference::Geometry behindTheLobe = geometry(direction(80, 0), direction(80, 0));

std::vector<Lobe> microfacets() {
    std::vector<Lobe> lobes;
    for (const EnumValue& d :
         catalog().find("models", "cook-torrance")->parameter("distribution")->values) {
        lobes.push_back({"models", "cook-torrance", {{"distribution", d.id}}, {"roughness"}});
    }
    for (const EnumValue& v : catalog().find("models", "ward")->parameter("variant")->values) {
        lobes.push_back({"models", "ward", {{"variant", v.id}}, {"roughness.x", "roughness.y"}});
    }
    lobes.push_back({"models", "anisotropic-ggx", {}, {"roughness"}});
    lobes.push_back({"models", "metallic-roughness", {{"metalness", 1.0}}, {"roughness"}});
    return lobes;
}

TEST(Limits, OfRoughnessZero_AreTheFloor) {
    for (const Lobe& lobe : microfacets()) {
        const double value = shaded(at(lobe, 0.0), mirrored);
        EXPECT_EQ(value, shaded(at(lobe, 1e-4), mirrored)) << lobe.model;
        EXPECT_GT(value, 1e5) << lobe.model;
    }
}

/// The models whose lobe is a power, with nothing but the lobe.
std::vector<Lobe> powers() {
    const Values alone{{"diffuse.color", black}, {"specular.color", white}};
    Values lafortune{
        {"diffuse.color", black}, {"lobe1.color", white}, {"normalisation", std::string("raw")}};
    Values fibre = alone;
    fibre["self.shadowing"] = false;
    return {{"models", "phong", alone, {"shininess"}},
            {"models", "blinn-phong", alone, {"shininess"}},
            {"models", "heidrich-seidel", fibre, {"shininess"}},
            {"models", "lafortune", lafortune, {"lobe1.exponent"}},
            {"specular", "phong", {{"specular.color", white}}, {"shininess"}},
            {"specular", "blinn-phong", {{"specular.color", white}}, {"shininess"}}};
}

double fullLobe(const Lobe& lobe, const reference::Geometry& g) {
    return std::string(lobe.model) == "lafortune" ? std::numbers::pi * g.l.z : 1.0;
}

TEST(Limits, OfExponentZero_AreOneWithinTheLobe) {
    for (const Lobe& lobe : powers()) {
        EXPECT_NEAR(shaded(at(lobe, 0.0), elsewhere), fullLobe(lobe, elsewhere), 1e-15)
            << lobe.model;
    }
}

TEST(Limits, OfExponentZero_AreZeroOutsideTheLobe) {
    for (const char* model : {"phong", "lafortune"}) {
        for (const Lobe& lobe : powers()) {
            if (lobe.model == std::string(model)) {
                EXPECT_EQ(shaded(at(lobe, 0.0), behindTheLobe), 0.0) << model;
            }
        }
    }
}

TEST(Limits, OfTheLargestExponent_AreOneInTheMirrorDirection) {
    for (const Lobe& lobe : powers()) {
        EXPECT_NEAR(shaded(at(lobe, 1e5), mirrored), fullLobe(lobe, mirrored), 1e-9) << lobe.model;
    }
}

TEST(Limits, OfNoWidth_AreOneInTheMirrorDirectionAlone) {
    const Lobe lobe{
        "models", "gaussian", {{"diffuse.color", black}, {"specular.color", white}}, {"width"}};
    const auto normal = geometry(direction(0, 0), direction(0, 0));
    EXPECT_EQ(shaded(at(lobe, 0.0), normal), 1.0);
    EXPECT_EQ(shaded(at(lobe, 0.0), elsewhere), 0.0);
}

/// At h = n the azimuth of h is 0/0; a little off it is not.
TEST(Limits, OfAnisotropicLobesInTheMirrorDirection_AreTheirNeighbours) {
    const auto normal = geometry(direction(0, 0), direction(0, 0));
    const auto beside = geometry(direction(1e-6, 33), direction(0, 0));
    for (const char* id :
         {"ward", "anisotropic-ggx", "ashikhmin-shirley", "heidrich-seidel", "poulin-fournier"}) {
        const Subject model("models", id);
        EXPECT_NEAR(shaded(model, beside) / shaded(model, normal), 1.0, 1e-5) << id;
    }
}

/// G / (n.v) is one expression: with the viewer in the surface it has a limit.
TEST(Limits, OfMaskedFacetsAtGrazingView_AreReached) {
    const glm::dvec3 l = direction(50, 180);
    for (const EnumValue& masking :
         catalog().find("models", "cook-torrance")->parameter("masking")->values) {
        const Subject model("models", "cook-torrance",
                            {{"masking", masking.id}, {"roughness", 0.6}});
        const double grazing = shaded(model, geometry(l, {1.0, 0.0, 1e-9}));
        EXPECT_GT(grazing, 0.0) << masking.id;
        EXPECT_NEAR(shaded(model, geometry(l, {1.0, 0.0, 1e-12})) / grazing, 1.0, 1e-7)
            << masking.id;
    }
}

/// Lobes around a half vector that is not there, of models that look at light or viewer only.
TEST(Limits, OfOppositeDirections_AreZero) {
    for (const char* kind : {"models", "specular"}) {
        for (const char* id : {"blinn-phong", "gaussian"}) {
            const Block& block = *catalog().find(kind, id);
            const bool matte = block.parameter("diffuse.color") != nullptr;
            const Subject lobe(kind, id, matte ? Values{{"diffuse.color", black}} : Values());
            for (const double degrees : {0.0, 30.0, 90.0}) {
                const glm::dvec3 l = direction(degrees, 20);
                EXPECT_EQ(shaded(lobe, geometry(l, -l)), 0.0) << kind << ' ' << id;
            }
        }
    }
}

TEST(Limits, OfMinnaertsLawWithDarkeningOne_AreLambertEvenAtTheRim) {
    const Subject model("models", "minnaert", {{"diffuse.color", white}, {"darkening", 1.0}});
    const auto rim = geometry(direction(30, 0), {1.0, 0.0, 1e-300});
    EXPECT_NEAR(shaded(model, rim), rim.l.z, 1e-15);
}

TEST(Limits, OfEonAtTheHorizon_AreFinite) {
    const Subject model("models", "oren-nayar",
                        {{"diffuse.color", white}, {"form", std::string("eon")}});
    const auto horizon = geometry({1.0, 0.0, 1e-300}, {-1.0, 0.0, 1e-300});
    EXPECT_NEAR(shaded(model, horizon), 0.0, 1e-290);
}

} // namespace
} // namespace patina::physics::limits_test
