// SPDX-License-Identifier: GPL-3.0-or-later
// Errors that the literature and the blocks' own texts name, as a sweep measures them.
#include <cmath>
#include <numbers>

#include "gpu_fixture.h"
#include "measure/cost/cost_sweep.h"
#include "measure/error/relative_error.h"

namespace patina::known_errors_test {
namespace {

class KnownErrorsTest : public GpuTest {
  protected:
    /// A sweep of one choice that is done; one pair of frames is enough where only errors count.
    std::unique_ptr<CostSweep> swept(const Scene& scene, const std::string& choice,
                                     glm::ivec2 size = {1, 1}) {
        CostSweep::Options options;
        options.size = size;
        options.only = {choice};
        options.combinations = false;
        options.pairs.min = 1;
        options.pairs.max = 1;
        auto sweep = CostSweep::create({scene, 0, scene.camera, meshSource(), catalog}, options);
        while (!(*sweep)->finished()) {
            (*sweep)->step(std::chrono::milliseconds(20));
        }
        EXPECT_EQ((*sweep)->problems(), Errors());
        return std::move(*sweep);
    }

    /// A plate that only has the values that are given, seen under `degrees` from its normal.
    Scene plateOf(const std::string& model, const Values& values, double degrees) const {
        Scene scene = simpleScene(model);
        scene.objects[0].mesh = "builtin:plane";
        scene.objects[0].rotation = {90.0, 0.0, 0.0};
        scene.objects[0].scale = glm::dvec3(100.0);
        scene.objects[0].material.model.parameters["diffuse.color"] = glm::dvec3(0.0);
        scene.objects[0].material.model.parameters["specular.color"] = glm::dvec3(1.0);
        for (const auto& [id, value] : values) {
            scene.objects[0].material.model.parameters[id] = value;
        }
        scene.camera.yaw = degrees;
        return scene;
    }

    /// Light from the other side, at the cosine `c` from the normal.
    Light lightAt(double c) const { return sun({std::sqrt((1.0 - c) * (1.0 + c)), 0.0, -c}); }
};

/// Returns how far the level is off in a picture of one pixel, in light.
double errorOf(const CostSweep& sweep, const std::string& choice, const std::string& level) {
    const double right = std::max(greatestOf(sweep.groundTruth()->colors.front()), minShownLight);
    return sweep.chart().find({{choice, level}})->error.max * right;
}

TEST_F(KnownErrorsTest, SchlickFresnelOfGlass_ErrsBy36ThousandthsNear85Degrees) {
    Scene scene = plateOf("lambert", {}, 85.0);
    scene.lights.clear();
    BlockValues fresnel = block("fresnel", "dielectric");
    fresnel.parameters["color"] = glm::dvec3(1.0);
    fresnel.parameters["index.outside"] = 1.0;
    fresnel.parameters["index.inside"] = 1.5;
    scene.objects[0].material.parts["fresnel"] = fresnel;
    scene.camera.fieldOfView = 1.0;
    constexpr int columns = 33;
    const auto sweep = swept(scene, "fresnel.reflectance.clear", {columns, 1});
    const std::vector<double> map = sweep->errorMap({{"fresnel.reflectance.clear", "schlick"}});
    double worst = 0.0;
    int place = 0;
    for (int i = 0; i < columns; ++i) {
        const std::size_t at = std::size_t(i);
        const double error = map[at] * greatestOf(sweep->groundTruth()->colors[at]);
        place = error > worst ? i : place;
        worst = std::max(worst, error);
    }
    EXPECT_NEAR(worst, 0.036, 0.0005);
    // A picture of one row is as high as its field of view, and as many times as wide.
    const double across =
        (place + 0.5 - 0.5 * columns) * 2.0 * std::tan(0.5 * 1.0 * std::numbers::pi / 180.0);
    EXPECT_LT(std::abs(std::atan(across)) * 180.0 / std::numbers::pi, 2.0);
}

TEST_F(KnownErrorsTest, SchlicksFraction_Gives1233InPlaceOf12) {
    Scene scene = plateOf("phong", {{"shininess", 64.0}}, 0.0);
    scene.lights = {lightAt(0.9)};
    const auto sweep = swept(scene, "power");
    const double right = sweep->groundTruth()->colors.front().g;
    EXPECT_NEAR(right, 0.0012, 0.00005);
    EXPECT_NEAR(right + errorOf(*sweep, "power", "rational"), 0.1233, 0.00005);
}

/// Each table at the angle of the light where it errs most for a viewer at 45 degrees.
TEST_F(KnownErrorsTest, TablesOfGrazingTerms_ErrByWhatTheirTextsSay) {
    const auto errorAt = [this](double c, const std::string& level) {
        Scene scene = plateOf(
            "strauss", {{"smoothness", 0.0}, {"metalness", 0.0}, {"transparency", 0.0}, {"k", 0.1}},
            45.0);
        scene.lights = {lightAt(c)};
        const double mirrored = std::sqrt(0.5) * (std::sqrt((1.0 - c) * (1.0 + c)) + c);
        const double lobe = 0.1 * mirrored * mirrored * mirrored;
        return errorOf(*swept(scene, "terms"), "terms", level) / lobe;
    };
    EXPECT_NEAR(errorAt(1.265625e-4, "table"), 1.3e-4, 0.05 * 1.3e-4);
    EXPECT_NEAR(errorAt(2.6265625e-3, "even-table"), 0.06, 0.05 * 0.06);
}

} // namespace
} // namespace patina::known_errors_test
