// SPDX-License-Identifier: GPL-3.0-or-later
// Claims that a descriptor does not make because of cases that chance does not meet: one of each.
#include <numbers>

#include <gtest/gtest.h>

#include "measure/stability/hemisphere_rule.h"
#include "physics_cases.h"
#include "support/measured_files.h"
#include "support/program.h"

namespace patina::physics::exemptions_test {
namespace {

constexpr double grazing = 1e-7;

TEST(RareExemptions, RawPoulinFournierLobe_DoesNotFadeAlongTheRidges) {
    const Subject model("models", "poulin-fournier",
                        {{"diffuse.color", black},
                         {"specular.color", white},
                         {"shininess", 0.0},
                         {"normalisation", "raw"}});
    const Subject mirror("fresnel", "constant", {{"f0", white}});
    const auto under = [&](double c) {
        const glm::dvec3 l{std::sqrt(1.0 - c * c), 0.0, c};
        return model.shade(geometry(l, {0.0, 0.0, 1.0}), mirror.filler()).x;
    };
    EXPECT_GT(under(0.3), 0.1);
    EXPECT_NEAR(under(grazing), under(0.3), 0.05 * under(0.3));
}

TEST(RareExemptions, SteepLafortuneLobe_IsBrighterAtTheHorizonThanTenDegreesAboveIt) {
    const Subject model("models", "lafortune",
                        {{"diffuse.color", black},
                         {"lobe1.color", white},
                         {"lobe1.x", glm::dvec3(1.2)},
                         {"lobe1.z", glm::dvec3(0.0)},
                         {"lobe1.exponent", glm::dvec3(1000.0)}});
    const glm::dvec3 viewer = direction(60.0, 0.0);
    const double low = model.shade(geometry({1.0, 0.0, grazing}, viewer)).x;
    EXPECT_GT(low, 1.0);
    EXPECT_GT(low, model.shade(geometry(direction(80.0, 0.0), viewer)).x);
}

TEST(RareExemptions, SmoothWhiteBaseOfGltf_GivesBackMoreThanArrives) {
    const glm::dvec3 l = direction(89.0, 0.0);
    for (const double metalness : {0.0, 1.0}) {
        const Subject model(
            "models", "metallic-roughness",
            {{"diffuse.color", white}, {"metalness", metalness}, {"roughness", 0.2}});
        double sum = 0.0;
        for (const WeightedDirection& to : hemisphereRule(l)) {
            sum += to.weight * model.shade(geometry(l, to.v)).x;
        }
        EXPECT_EQ(sum / l.z > 1.0, metalness == 0.0) << sum / l.z;
    }
}

TEST(RareExemptions, StraussUnderLightBelowThreeDegrees_GivesBackMoreThanArrives) {
    const Subject model("models", "strauss", {{"diffuse.color", white}});
    const glm::dvec3 l = direction(89.0, 0.0);
    double sum = 0.0;
    for (const WeightedDirection& to : hemisphereRule(l)) {
        sum += to.weight * model.shade(geometry(l, to.v)).x;
    }
    EXPECT_GT(sum / l.z, 1.1);
}

/// What a light at 85 degrees gives back is more than arrives unless the lobe is multiplied by n.l.
TEST(RareExemptions, PublishedHighlightsUnderAGrazingLight_GiveBackMoreThanArrives) {
    const glm::dvec3 l = direction(85.0, 0.0);
    for (const auto& [id, size] : {std::pair("schlick", "shininess"), {"gaussian", "width"}}) {
        for (const char* kind : {"models", "specular"}) {
            for (const char* form : {"raw", "reciprocal"}) {
                Values values{
                    {"specular.color", white}, {size, 2.0}, {"highlight.form", std::string(form)}};
                if (kind == std::string("models")) {
                    values["diffuse.color"] = black;
                }
                const Subject highlight(kind, id, values);
                double sum = 0.0;
                for (const WeightedDirection& to : hemisphereRule(l)) {
                    sum += to.weight * highlight.shade(geometry(l, to.v)).x;
                }
                EXPECT_EQ(sum / l.z > 1.0, form == std::string("raw")) << kind << id << form << sum;
            }
        }
    }
}

TEST(RareExemptions, FileOfABrighterSurface_GivesBackMoreThanArrives) {
    const tests::TemporaryFolder folder;
    tests::writeFile(folder / "a.binary", tests::merlBytes({2, 2, 2}, [](const DirectionPair&) {
                         return glm::dvec3(1.5 / std::numbers::pi);
                     }));
    for (const char* id : {"measured", "measured-grain"}) {
        const Subject model("models", id, {{"file", (folder / "a.binary").string()}});
        EXPECT_NEAR(model.shade(geometry({0.0, 0.0, 1.0}, direction(60.0, 0.0))).x, 1.5, 1e-6)
            << id;
    }
}

} // namespace
} // namespace patina::physics::exemptions_test
