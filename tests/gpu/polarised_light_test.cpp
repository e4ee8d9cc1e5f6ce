// SPDX-License-Identifier: GPL-3.0-or-later
// Polarised light and the Fresnel terms that it meets.
#include <array>
#include <cmath>

#include "catalog/parameter_layout.h"
#include "gpu_fixture.h"
#include "measure/lobe/fresnel_curve.h"
#include "reference/reference.h"
#include "shading/effects/effect_rows.h"
#include "shading/effects/surface_program.h"

namespace patina::polarised_light_test {
namespace {

/// The plane of incidence of the plate is that of x and z.
const glm::dvec3 across(0.0, 1.0, 0.0);

class PolarisedLight : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    /// Makes a plate that mirrors a light at an angle, in degrees, towards the camera.
    Scene mirror(const std::string& fresnel, double degrees) const {
        Scene scene = plate();
        scene.background = glm::dvec3(0.0);
        scene.objects[0].material.model = block("models", "cook-torrance");
        Values& model = scene.objects[0].material.model.parameters;
        model["diffuse.color"] = glm::dvec3(0.0);
        model["roughness"] = 0.3;
        BlockValues& part = scene.objects[0].material.parts["fresnel"];
        part = block("fresnel", fresnel);
        if (const Parameter* f0 = catalog->find("fresnel", fresnel)->withRole(roles::f0)) {
            part.parameters[f0->id] = glm::dvec3(0.04);
        }
        scene.objects[0].rotation = {90.0, degrees, 0.0};
        const double twice = glm::radians(2.0 * degrees);
        scene.lights[0].block.parameters["direction"] =
            -glm::dvec3(std::sin(twice), 0.0, std::cos(twice));
        return scene;
    }

    static Scene polarised(Scene scene, const glm::dvec3& direction) {
        scene.lights[0].block.parameters["polarised"] = 1.0;
        scene.lights[0].block.parameters["polarised.direction"] = direction;
        return scene;
    }

    glm::dvec3 seen(const Scene& scene, int size = 9) {
        return glm::dvec3(middle(capture(scene, false, size)));
    }

    std::string text(const Scene& scene) const {
        const EffectSet set = effectSet(scene.objects[0].material, scene, *catalog);
        const auto program = surfaceProgram(set, *catalog);
        EXPECT_TRUE(program);
        return program ? program->fragment.text : std::string();
    }
};

/// Swinging in the plane of incidence.
const glm::dvec3 along(1.0, 0.0, 0.0);

TEST_F(PolarisedLight, OfDegreeZero_IsNotInTheText) {
    Scene scene = mirror("dielectric", 40.0);
    const std::string plain = text(scene);
    EXPECT_EQ(plain.find("olarised"), std::string::npos);
    scene.lights[0].block.parameters["polarised.direction"] = along;
    EXPECT_EQ(text(scene), plain);
    scene.lights[0].block.parameters["polarised"] = 0.5;
    EXPECT_NE(text(scene).find("fieldAcross"), std::string::npos);
}

/// Brewster 1815: tan theta = n.
TEST_F(PolarisedLight, InThePlaneOfIncidenceAtBrewstersAngle_IsDark) {
    const Scene scene = mirror("dielectric", glm::degrees(std::atan(1.5)));
    constexpr int size = 33; // a pixel of which is a degree wide
    const double ordinary = seen(scene, size).y;
    EXPECT_GT(ordinary, 0.01);
    EXPECT_LT(seen(polarised(scene, along), size).y, 2e-4 * ordinary);
    EXPECT_NEAR(seen(polarised(scene, across), size).y, 2.0 * ordinary, 2e-3 * ordinary);
}

/// The same by the constants of glass.
TEST_F(PolarisedLight, AtBrewstersAngleOfConstants_IsDark) {
    const Scene scene = mirror("dispersive", glm::degrees(std::atan(1.5186))); // at 549 nm
    constexpr int size = 33;
    const double ordinary = seen(scene, size).y;
    EXPECT_GT(ordinary, 0.01);
    EXPECT_LT(seen(polarised(scene, along), size).y, 2e-4 * ordinary);
}

/// Of a film each part is its own: neither of the bare glass.
TEST_F(PolarisedLight, OnAFilm_IsReflectedAsInDoublePrecision) {
    const Block& film = *catalog->find("fresnel", "thin-film");
    const Values values = defaults("fresnel", "thin-film");
    for (const double degrees : {30.0, 50.0, 70.0}) {
        Scene scene = mirror("thin-film", degrees);
        scene.objects[0].material.parts["fresnel"].parameters = values;
        const double c = std::cos(glm::radians(degrees));
        const std::array<double, 2> incidence{c, 1.0 - c};
        const std::vector<double> packedValues = packed(film, values, {});
        const reference::Block& code = *reference::findBlock("fresnel", "thin-film");
        const auto right = code.call<3>(reference::acrossSuffix, incidence, packedValues);
        const glm::dvec3 ordinary = code.fresnel(c, 1.0 - c, packedValues);
        const glm::dvec3 s = seen(polarised(scene, across));
        const glm::dvec3 p = seen(polarised(scene, along));
        for (int channel = 0; channel < 3; ++channel) {
            const double ratio = 2.0 * ordinary[channel] / right[std::size_t(channel)] - 1.0;
            EXPECT_NEAR(p[channel] / s[channel], ratio, 4e-3) << degrees << ' ' << channel;
        }
    }
}

/// A term that names no index says what it is taken for.
TEST_F(PolarisedLight, OnAnEmpiricalTerm_IsThatOfAClearMaterialAndItsRowSaysSo) {
    const auto reason = [this](const Scene& scene) {
        for (const EffectRow& row : effectRows(scene, 0, *catalog)) {
            if (row.line.effect == "fresnel/empirical") {
                return row.line.reason;
            }
        }
        return std::string();
    };
    Scene scene = mirror("empirical", 50.0);
    scene.objects[0].material.parts["fresnel"].parameters["bias"] = 0.04; // an index of 1.5
    EXPECT_EQ(reason(scene), "The material chooses it for the model.");
    EXPECT_EQ(
        reason(polarised(scene, along)),
        "The material chooses it for the model. It names no index: polarised light is mirrored "
        "as by the clear material that mirrors as much facing it.");
    const auto media =
        interfaceOf(*catalog->find("fresnel", "dielectric"), defaults("fresnel", "dielectric"));
    ASSERT_TRUE(media);
    const PolarisedPoint right = reflectedAt(*media, glm::radians(50.0), false);
    EXPECT_NEAR(seen(polarised(scene, along)).y / seen(polarised(scene, across)).y,
                right.p.y / right.s.y, 4e-3);
}

TEST_F(PolarisedLight, OnAModelWithoutAFresnelTerm_CountsAsOrdinaryAndARowSaysSo) {
    const auto reason = [this](const Scene& scene) {
        for (const EffectRow& row : effectRows(scene, 0, *catalog)) {
            if (row.line.effect == "polarised light") {
                return row.in ? "in" : row.line.reason;
            }
        }
        return std::string();
    };
    Scene scene = mirror("dielectric", 50.0);
    EXPECT_EQ(reason(polarised(scene, along)), "");
    scene.objects[0].material = object("phong").material;
    EXPECT_EQ(reason(scene), "");
    EXPECT_EQ(seen(polarised(scene, along)), seen(scene));
    EXPECT_EQ(reason(polarised(scene, along)),
              "The model has no Fresnel term in its slot, which alone would answer to it: it "
              "counts as ordinary light.");
}

/// Where a term reflects nothing facing it the index is 1, and what is reflected along is to what
/// is across as the square of the cosine of twice the angle: the limit of Fresnel's equations.
TEST_F(PolarisedLight, OnTermsThatMirrorNothingFacingThem_IsTheLimitOfFresnels) {
    for (const char* fresnel : {"strauss", "schlick", "empirical"}) {
        Scene scene = mirror(fresnel, 60.0);
        if (const Parameter* f0 = catalog->find("fresnel", fresnel)->withRole(roles::f0)) {
            scene.objects[0].material.parts["fresnel"].parameters[f0->id] = glm::dvec3(0.0);
        }
        EXPECT_NEAR(seen(polarised(scene, along)).y / seen(polarised(scene, across)).y, 0.25, 4e-3)
            << fresnel;
    }
}

/// At Brewster's angle of a high reflectance, where Fresnel's own dips, Schlick's rises.
TEST_F(PolarisedLight, OnATermThatMirrorsMuch_IsNoMoreThanAllOfIt) {
    Scene scene = mirror("schlick", 80.0);
    scene.objects[0].material.parts["fresnel"].parameters["f0"] = glm::dvec3(0.5);
    const double ordinary = seen(scene).y; // of a reflectance of 0.5 + 0.5 (1 - cos 80)^5
    const double reflectance = 0.5 + 0.5 * std::pow(1.0 - std::cos(glm::radians(80.0)), 5.0);
    const double all = ordinary / reflectance;
    EXPECT_NEAR(seen(polarised(scene, across)).y, all, 4e-3 * all);
}

/// Ordinary light is half of each, whatever the term.
TEST_F(PolarisedLight, AcrossAndAlong_AddUpToOrdinaryLight) {
    for (const Block* fresnel : catalog->ofKind("fresnel")) {
        SCOPED_TRACE(fresnel->id);
        const Scene scene = mirror(fresnel->id, 50.0);
        const glm::dvec3 both = seen(scene);
        const glm::dvec3 one = seen(polarised(scene, across));
        const glm::dvec3 other = seen(polarised(scene, along));
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(one[channel] + other[channel], 2.0 * both[channel],
                        4e-3 * both[channel] + 1e-6);
        }
        EXPECT_GT(one.y, 1.02 * other.y);
    }
}

TEST_F(PolarisedLight, OnMetals_IsReflectedByFresnelsEquations) {
    for (const double degrees : {30.0, 60.0, 75.0}) {
        const Scene scene = mirror("conductor", degrees);
        const auto media =
            interfaceOf(*catalog->find("fresnel", "conductor"), defaults("fresnel", "conductor"));
        ASSERT_TRUE(media);
        const PolarisedPoint right = reflectedAt(*media, glm::radians(degrees), false);
        const glm::dvec3 s = seen(polarised(scene, across));
        const glm::dvec3 p = seen(polarised(scene, along));
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(p[channel] / s[channel], right.p[channel] / right.s[channel], 3e-3)
                << degrees << ' ' << channel;
        }
    }
}

/// |F|^2 of He et al. 1991 is (c_s |F_s|)^2 + (c_p |F_p|)^2 at half the angle between light and
/// viewer, and nothing else in their model knows of polarisation.
TEST_F(PolarisedLight, OnARoughWaveSurface_IsReflectedByFresnelsEquations) {
    for (const char* fresnel : {"dielectric", "conductor"}) {
        const auto media =
            interfaceOf(*catalog->find("fresnel", fresnel), defaults("fresnel", fresnel));
        ASSERT_TRUE(media);
        for (const double degrees : {30.0, 50.0, 70.0}) {
            Scene scene = mirror(fresnel, degrees);
            scene.objects[0].material.model = block("models", "he-torrance");
            Values& model = scene.objects[0].material.model.parameters;
            model["diffuse.color"] = glm::dvec3(0.0);
            model["sigma0"] = 0.4;
            model["tau"] = 2.0;
            scene.objects[0].rotation.y += 4.0; // beside the mirror direction
            const PolarisedPoint right = reflectedAt(*media, glm::radians(degrees), false);
            const glm::dvec3 s = seen(polarised(scene, across));
            const glm::dvec3 p = seen(polarised(scene, along));
            const glm::dvec3 both = seen(scene);
            for (int channel = 0; channel < 3; ++channel) {
                EXPECT_GT(both[channel], 1e-4);
                EXPECT_NEAR(p[channel] / s[channel], right.p[channel] / right.s[channel], 4e-3)
                    << fresnel << ' ' << degrees << ' ' << channel;
                EXPECT_NEAR(s[channel] + p[channel], 2.0 * both[channel], 4e-3 * both[channel]);
            }
        }
    }
}

/// A degree between is so much of the one, the rest ordinary; a slanted line is both.
TEST_F(PolarisedLight, InPart_IsAMixture) {
    const Scene scene = mirror("dielectric", 50.0);
    const double ordinary = seen(scene).y;
    const double whole = seen(polarised(scene, across)).y;
    Scene half = polarised(scene, across);
    half.lights[0].block.parameters["polarised"] = 0.5;
    EXPECT_NEAR(seen(half).y, 0.5 * (ordinary + whole), 2e-3 * whole);
    const glm::dvec3 towards =
        -std::get<glm::dvec3>(scene.lights[0].block.parameters.at("direction"));
    const glm::dvec3 beside = glm::normalize(glm::cross(across, towards));
    EXPECT_NEAR(seen(polarised(scene, across + beside)).y, ordinary, 2e-3 * ordinary);
}

TEST_F(PolarisedLight, InAnyDirection_IsFiniteAndNotNegative) {
    Scene scene = mirror("dielectric", 50.0);
    for (const glm::dvec3& direction :
         {glm::dvec3(0.0), glm::dvec3(1e6, 1e-6, 0.0), glm::dvec3(0.0, 0.0, -1.0)}) {
        for (const double degrees : {0.0, 50.0, 89.9}) {
            Scene each = polarised(mirror("conductor", degrees), direction);
            for (const float value : capture(each, false, 9).pixels) {
                ASSERT_TRUE(value >= 0.0f && value <= 65504.0f) << degrees;
            }
        }
    }
}

} // namespace
} // namespace patina::polarised_light_test
