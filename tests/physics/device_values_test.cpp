// SPDX-License-Identifier: GPL-3.0-or-later
// Single values on the graphics device beside what theory or double precision says of them.
#include <algorithm>
#include <cmath>
#include <random>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "measure/eval/eval_gpu.h"
#include "measure/eval/eval_reference.h"
#include "physics_cases.h"
#include "support/long_form.h"

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

/// The published forms beside it are not: light and viewer stand at 70 and 20 degrees.
TEST_F(DeviceValues, ReciprocalForms_LetLightAndViewerChangePlaces) {
    for (const char* model : {"schlick", "gaussian"}) {
        for (const bool reciprocal : {false, true}) {
            EvalCase request = facing(model);
            request.block.values["diffuse.color"] = glm::dvec3(0.0);
            request.block.values["highlight.form"] = std::string(reciprocal ? "reciprocal" : "raw");
            request.l = direction(70.0, 0.0);
            request.v = direction(20.0, 160.0);
            const double there = onDevice(request) / request.l.z;
            EXPECT_GT(there, 1e-4);
            std::swap(request.l, request.v);
            const double ratio = onDevice(request) / request.l.z / there;
            EXPECT_NEAR(ratio, reciprocal ? 1.0 : 0.34202 / 0.93969, 1e-4) << model;
        }
    }
}

/// A model of a power of a cosine, and what its level "rounded" states to be off at most, as a
/// share of the peak for each unit of the exponent.
struct RoundedModel {
    const char* id;
    double stated;
    const char* choice = "power";
    std::vector<const char*> exponents{"shininess"}; ///< are parameters
};

/// A white highlight of a model alone, of this exponent in all its channels.
EvalCase highlightOf(const RoundedModel& model, double exponent) {
    EvalCase request = facing(model.id);
    const Block& block = *request.block.block;
    for (const Parameter& parameter : block.parameters) {
        if (parameter.id.ends_with(".color")) {
            request.block.values[parameter.id] =
                parameter.id == "specular.color" || parameter.id == "lobe1.color" ? white : black;
        }
    }
    for (const char* id : model.exponents) {
        const bool isOfChannels = std::holds_alternative<glm::dvec3>(request.block.values.at(id));
        request.block.values[id] = isOfChannels ? Value(glm::dvec3(exponent)) : Value(exponent);
    }
    if (!block.slots.empty()) {
        request.slot.block = catalog().find("fresnel", "constant");
        request.slot.values = {{"f0", white}};
    }
    return request;
}

class RoundedPower : public testing::TestWithParam<RoundedModel> {};

/// Any normal, a viewer down to 3 degrees above the surface, every other time almost there, and
/// light as high or higher, within a few widths of the lobe of this exponent.
void placeNearMirror(EvalCase& request, double exponent, std::mt19937& random) {
    constexpr double steepest = 87.0;
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::normal_distribution<double> step(0.0, 1.5 / std::sqrt(exponent));
    const double angle =
        share(random) < 0.5 ? steepest - 5.0 * share(random) : steepest * std::sqrt(share(random));
    request.v = direction(angle, 360.0 * share(random));
    const glm::dvec3 near = glm::dvec3(-request.v.x, -request.v.y, request.v.z) +
                            glm::dvec3(step(random), step(random), step(random));
    const double lowest = direction(steepest, 0.0).z;
    request.l = glm::normalize(glm::dvec3(near.x, near.y, std::max(near.z, lowest)));
    const glm::dmat3 turned(
        glm::rotate(glm::dmat4(1.0), 6.3 * share(random),
                    glm::normalize(direction(180.0 * share(random), 360.0 * share(random)))));
    request.n = turned[2];
    request.t = turned[0];
    for (glm::dvec3* each : {&request.l, &request.v}) {
        *each = turned * *each;
    }
    for (glm::dvec3* each : {&request.n, &request.t, &request.l, &request.v}) {
        *each = glm::dvec3(glm::vec3(*each));
    }
}

/// Is a case with how far a highlight is off in it.
struct JudgedCase {
    EvalCase request;
    double error = 0.0; ///< is a share of the peak
};

/// Judges cases whose highlights are `peak` in their middle.
void judge(std::vector<JudgedCase>& cases, double peak, const RoundedModel& model, EvalGpu& gpu) {
    std::vector<EvalCase> rounded;
    for (const JudgedCase& each : cases) {
        rounded.push_back(each.request);
        rounded.back().block.accuracy[model.choice] = "rounded";
    }
    const auto answers = gpu.evaluate(rounded, catalog());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        ASSERT_TRUE(answers[i]) << answers[i].error().text();
        const double exact = evaluatedInDouble(cases[i].request).value()[0];
        // A lobe that grows as light and viewer graze is off by a share of its own.
        cases[i].error = std::abs((*answers[i])[0] - exact) / std::max(peak, exact);
    }
}

/// Moves one of the three directions by a step of any size; not where light or viewer would be
/// lower than cases are drawn.
void move(EvalCase& request, std::mt19937& random) {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::normal_distribution<double> part;
    const double size = std::pow(10.0, -7.5 + 6.0 * share(random));
    glm::dvec3* const each[] = {&request.n, &request.l, &request.v};
    glm::dvec3& moved = *each[std::min(int(3.0 * share(random)), 2)];
    const glm::dvec3 before = moved;
    moved += size * glm::dvec3(part(random), part(random), part(random));
    moved = glm::dvec3(glm::vec3(glm::normalize(moved)));
    const double lowest = direction(87.0, 0.0).z;
    if (glm::dot(request.n, request.l) < lowest || glm::dot(request.n, request.v) < lowest) {
        moved = before;
    }
}

/// Returns the largest error that is found from these cases by moves that make it larger.
double climbed(std::vector<JudgedCase> cases, double peak, const RoundedModel& model, EvalGpu& gpu,
               std::mt19937& random) {
    constexpr std::size_t climbers = 24;
    constexpr std::size_t tries = 6;
    const int climbingRounds = tests::casesOf(60, 800);
    std::ranges::sort(cases, std::ranges::greater(), &JudgedCase::error);
    cases.resize(climbers);
    for (int i = 0; i < climbingRounds; ++i) {
        std::vector<JudgedCase> moved;
        for (const JudgedCase& each : cases) {
            for (std::size_t k = 0; k < tries; ++k) {
                moved.push_back(each);
                move(moved.back().request, random);
            }
        }
        judge(moved, peak, model, gpu);
        for (std::size_t k = 0; k < moved.size(); ++k) {
            if (moved[k].error > cases[k / tries].error) {
                cases[k / tries] = moved[k];
            }
        }
    }
    return std::ranges::max(cases, {}, &JudgedCase::error).error;
}

TEST_P(RoundedPower, OfAnySharpness_ErrsByNoMoreThanItStates) {
    constexpr int casesEach = 34000; // a hundred thousand in all
    std::mt19937 random(1);
    EvalGpu gpu;
    for (const double exponent : {20.0, 200.0, 1000.0}) {
        EvalCase request = highlightOf(GetParam(), exponent);
        const double peak = evaluatedInDouble(request).value()[0];
        std::vector<JudgedCase> cases;
        for (int i = 0; i < casesEach; ++i) {
            placeNearMirror(request, exponent, random);
            cases.push_back({request});
        }
        judge(cases, peak, GetParam(), gpu);
        const double drawn = std::ranges::max(cases, {}, &JudgedCase::error).error;
        const double worst = climbed(std::move(cases), peak, GetParam(), gpu, random);
        EXPECT_LE(worst, GetParam().stated * exponent) << exponent << ", drawn " << drawn;
        EXPECT_GT(worst, 0.1 * GetParam().stated * exponent) << "it states too much";
    }
}

INSTANTIATE_TEST_SUITE_P(
    EveryModel, RoundedPower,
    testing::Values(RoundedModel{"phong", 6.5e-7}, RoundedModel{"heidrich-seidel", 5e-7},
                    RoundedModel{"lafortune", 4.5e-7, "falloff", {"lobe1.exponent"}},
                    RoundedModel{
                        "ashikhmin-shirley", 1.5e-6, "falloff", {"shininess.x", "shininess.y"}}),
    [](const auto& tested) {
        std::string name = tested.param.id;
        std::erase(name, '-');
        return name;
    });

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
