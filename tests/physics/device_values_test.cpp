// SPDX-License-Identifier: GPL-3.0-or-later
// Single values on the graphics device beside what theory or double precision says of them.
#include <gtest/gtest.h>

#include <cmath>

#include "measure/eval/eval_gpu.h"
#include "measure/eval/eval_reference.h"
#include "physics_cases.h"

namespace patina::physics::device_values_test {
namespace {

/// A model with all its values at their defaults, facing light and viewer.
EvalCase facing(const std::string& model) {
    EvalCase request;
    request.block.block = catalog().find("models", model);
    request.block.values = defaultValues(*request.block.block);
    request.l = {0.0, 0.0, 1.0};
    request.v = {0.0, 0.0, 1.0};
    return request;
}

/// One context and one program for each model of a test.
class DeviceValues : public testing::Test {
  protected:
    double onDevice(const EvalCase& request) {
        const auto answers = gpu_.evaluate({&request, 1}, catalog());
        EXPECT_TRUE(answers.front()) << answers.front().error().text();
        return answers.front() ? (*answers.front())[0] : NAN;
    }

  private:
    EvalGpu gpu_;
};

/// The half vector is the small difference of the two: a step of float in either is 0.3 %.
TEST_F(DeviceValues, NearlyOppositeUnitDirections_StayAsTheyAre) {
    EvalCase request = facing("blinn-phong");
    request.block.values["shininess"] = 100000.0;
    request.block.values["diffuse.color"] = glm::dvec3(0.0);
    request.block.values["specular.color"] = glm::dvec3(1.0);
    request.l = {-0.033311206847429276, 0.9994323253631592, 0.005037827882915735};
    request.v = {0.03331147879362106, -0.9994450211524963, 9.999999747378752e-06};
    const double exact = evaluatedInDouble(request).value()[0];
    EXPECT_NEAR(exact, 0.729033, 1e-6);
    EXPECT_NEAR(onDevice(request) / exact, 1.0, 5e-4);
}

/// Normals whose float forms have a dot product with themselves of 1 and a little off 1.
constexpr glm::dvec3 normals[] = {
    {0.0, 0.0, 1.0}, {0.1, 0.7, 0.3}, {-1.0, 1e-4, -2e-3}, {0.2, 0.9, 0.4}};

void lookAlong(EvalCase& request, const glm::dvec3& normal) {
    request.n = request.l = request.v = glm::dvec3(glm::vec3(normal));
}

TEST_F(DeviceValues, MinnaertFacingLightAndViewer_IsItsColour) {
    EvalCase request = facing("minnaert");
    request.block.values["diffuse.color"] = glm::dvec3(1.0);
    for (const glm::dvec3& normal : normals) {
        lookAlong(request, normal);
        for (const double darkening : {0.0, 0.5, 1.0, 2.0, 10.0}) {
            request.block.values["darkening"] = darkening;
            EXPECT_NEAR(onDevice(request), 1.0, 3e-7) << normal.x << ' ' << darkening;
        }
    }
}

class HardEdgedHalftone : public DeviceValues, public testing::WithParamInterface<const char*> {};

/// Both tones at 1: the paper is bare where the light falls straight on it, whatever the normal.
TEST_P(HardEdgedHalftone, LightAlongTheNormal_LeavesThePaperBare) {
    EvalCase request = facing("halftone");
    request.block.values["pattern"] = std::string(GetParam());
    request.block.values["cell"] = 256.0;
    request.block.values["diffuse.color"] = glm::dvec3(1.0);
    request.block.values["ink.color"] = glm::dvec3(0.0);
    request.block.values["tone.light"] = 1.0;
    request.block.values["tone.dark"] = 1.0;
    for (const glm::dvec3& normal : normals) {
        lookAlong(request, normal);
        for (const glm::dvec2& pixel : {glm::dvec2(0.0), glm::dvec2(17.0, 40.0)}) {
            request.pixel = pixel;
            EXPECT_NEAR(evaluatedInDouble(request).value()[0], 1.0, 1e-12);
            EXPECT_NEAR(onDevice(request), 1.0, 1e-6) << normal.x << ' ' << pixel.x;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(EveryPattern, HardEdgedHalftone,
                         testing::Values("dots", "lines", "cross"));

/// Places half-way between two strokes, where the rounding of the turn decides on which side they
/// count, are as black as both strokes make them.
TEST_F(DeviceValues, HatchingTurnedOnce_DrawsTheSameStrokes) {
    EvalCase request = facing("hatching");
    request.block.values["diffuse.color"] = glm::dvec3(1.0);
    request.block.values["ink.color"] = glm::dvec3(0.0);
    request.block.values["wobble"] = 1.0;
    request.block.values["pen.width"] = 6.0;
    request.block.values["angle.cross"] = 0.0;
    request.l = {0.8, 0.0, 0.6};
    for (const double turn : {-360.0, 360.0}) {
        for (int x = 0; x < 64; ++x) {
            request.pixel = {x, 0.0};
            request.block.values["angle"] = 0.0;
            const double straight = evaluatedInDouble(request).value()[0];
            request.block.values["angle"] = turn;
            EXPECT_NEAR(evaluatedInDouble(request).value()[0], straight, 1e-6) << x;
            EXPECT_NEAR(onDevice(request), straight, 1e-4) << turn << " degrees, pixel " << x;
        }
    }
}

} // namespace
} // namespace patina::physics::device_values_test
