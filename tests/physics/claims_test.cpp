// SPDX-License-Identifier: GPL-3.0-or-later
// Every promise a descriptor makes, tested on every block that makes it.
#include <gtest/gtest.h>

#include <array>

#include <glm/geometric.hpp>

#include "measure/eval_gpu.h"
#include "measure/eval_reference.h"
#include "random_cases.h"

namespace patina::physics {
namespace {

constexpr int hardCases = 100000;
constexpr int ordinaryCases = 20000;

/// The model's value before it is cut at 0, or what any other block gives.
std::vector<double> rawValue(const EvalCase& request) {
    if (request.subject != EvalCase::Subject::Model) {
        return evaluatedInDouble(request).value();
    }
    const Block& block = *request.block.block;
    const auto parameters = request.block.packedValues();
    std::vector<double> slotParameters;
    reference::Filler filler;
    if (request.slot.block != nullptr) {
        slotParameters = request.slot.packedValues();
        filler = {reference::findBlock(request.slot.block->kind, request.slot.block->id),
                  slotParameters};
    }
    const auto geometry = reference::geometry(request.n, request.t, request.l, request.v);
    const auto value = reference::modelValue(*reference::findBlock(block.kind, block.id), geometry,
                                             parameters, {&filler, 1});
    return {value.x, value.y, value.z};
}

/// Of a light, only what it sends has a sign.
std::span<const double> signedPart(const EvalCase& request, const std::vector<double>& values) {
    return std::span(values).subspan(request.subject == EvalCase::Subject::Light ? 3 : 0);
}

void expectFinite(const EvalCase& request, const std::vector<double>& values) {
    for (const double x : values) {
        ASSERT_TRUE(std::isfinite(x)) << described(request, values, {});
    }
}

void finite(const Block& block) {
    HardCases hard(block);
    for (int i = 0; i < hardCases; ++i) {
        const EvalCase request = hard.next();
        ASSERT_NO_FATAL_FAILURE(expectFinite(request, rawValue(request)));
    }
}

/// In float on the graphics device, where subnormals are flushed and built-in functions are coarse.
void finiteOnTheGpu(const Block& block) {
    HardCases hard(block);
    std::vector<EvalCase> cases;
    for (int i = 0; i < hardCases; ++i) {
        cases.push_back(hard.next());
    }
    EvalGpu gpu;
    const auto answers = gpu.evaluate(cases, catalog());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        ASSERT_TRUE(answers[i]) << answers[i].error().text();
        ASSERT_NO_FATAL_FAILURE(expectFinite(cases[i], *answers[i]));
    }
}

void nonNegative(const Block& block) {
    HardCases hard(block);
    for (int i = 0; i < hardCases; ++i) {
        const EvalCase request = hard.next();
        const std::vector<double> values = rawValue(request);
        for (const double x : signedPart(request, values)) {
            ASSERT_GE(x, 0.0) << described(request, values, {});
        }
    }
}

/// f(l, v) = f(v, l), with f = value / (n.l).
void reciprocal(const Block& block) {
    OrdinaryCases ordinary(block);
    ordinary.leaveOptionalSlotsEmpty();
    for (int i = 0; i < ordinaryCases; ++i) {
        const EvalCase request = ordinary.next();
        EvalCase exchanged = request;
        std::swap(exchanged.l, exchanged.v);
        const double nl = glm::normalize(request.l).z;
        const double nv = glm::normalize(request.v).z;
        const double f = rawValue(request)[0] / nl;
        ASSERT_NEAR(f, rawValue(exchanged)[0] / nv, 1e-10 * (1.0 + f))
            << described(request, rawValue(request), rawValue(exchanged));
    }
}

/// The same case with every colour at its largest.
EvalCase brightest(EvalCase request) {
    for (EvalBlock* block : {&request.block, &request.slot}) {
        for (auto& [id, value] : block->values) {
            if (block->block->parameter(id)->type == ParameterType::Color) {
                value = glm::dvec3(block->block->parameter(id)->max);
            }
        }
    }
    return request;
}

/// The directional albedo, the integral of f (n.v) over the hemisphere of v, by the midpoint rule
/// in cos^2 and azimuth.
double albedo(EvalCase request) {
    constexpr int rings = 48;
    constexpr int sectors = 64;
    double sum = 0.0;
    for (int ring = 0; ring < rings; ++ring) {
        const double nv = std::sqrt((ring + 0.5) / rings);
        const double s = std::sqrt(1.0 - nv * nv);
        for (int sector = 0; sector < sectors; ++sector) {
            const double phi = 2.0 * std::numbers::pi * (sector + 0.5) / sectors;
            request.v = {s * std::cos(phi), s * std::sin(phi), nv};
            sum += rawValue(request)[0];
        }
    }
    return sum / (rings * sectors) / glm::normalize(request.l).z;
}

void energyConserving(const Block& block) {
    HardCases hard(block);
    if (block.kind != "models" && block.kind != "specular") {
        for (int i = 0; i < hardCases; ++i) {
            ASSERT_LE(rawValue(hard.next())[0], 1.0);
        }
        return;
    }
    OrdinaryCases ordinary(block);
    ordinary.leaveOptionalSlotsEmpty();
    for (int i = 0; i < 50; ++i) {
        const EvalCase request = brightest(ordinary.next());
        ASSERT_LE(albedo(request), 1.0 + 1e-3) << described(request, {}, {});
    }
}

glm::dvec3 turned(const glm::dvec3& v, double angle) {
    return {v.x * std::cos(angle) - v.y * std::sin(angle),
            v.x * std::sin(angle) + v.y * std::cos(angle), v.z};
}

void isotropic(const Block& block) {
    OrdinaryCases ordinary(block);
    ordinary.leaveOptionalSlotsEmpty();
    for (int i = 0; i < ordinaryCases; ++i) {
        const EvalCase request = ordinary.next();
        EvalCase rotated = request;
        rotated.l = turned(request.l, 0.7 + i);
        rotated.v = turned(request.v, 0.7 + i);
        const double value = rawValue(request)[0];
        ASSERT_NEAR(value, rawValue(rotated)[0], 1e-10 * (1.0 + value))
            << described(request, {}, {});
    }
}

void zeroBelowHorizon(const Block& block) {
    HardCases hard(block);
    for (int i = 0; i < hardCases; ++i) {
        const EvalCase request = hard.next();
        if (request.l.z <= 0.0 || request.v.z <= 0.0) {
            ASSERT_EQ(rawValue(request)[0], 0.0) << described(request, rawValue(request), {});
        }
    }
}

/// At 1e-7 rad above the horizon at most a thousandth of what the same light gives higher up.
void continuousAtHorizon(const Block& block) {
    OrdinaryCases ordinary(block);
    ordinary.leaveOptionalSlotsEmpty();
    for (int i = 0; i < ordinaryCases / 10; ++i) {
        EvalCase request = brightest(ordinary.next());
        request.v = direction(60.0, 37.0 * i);
        double largest = 0.0;
        for (const double degrees : {0.0, 20.0, 40.0, 60.0, 80.0}) {
            request.l = direction(degrees, 37.0 * i + 180.0);
            largest = std::max(largest, rawValue(request)[0]);
        }
        request.l = {std::cos(1.0 * i), std::sin(1.0 * i), 1e-7};
        ASSERT_LE(rawValue(request)[0], 1e-3 * largest + 1e-12) << described(request, {}, {});
    }
}

/// Of a Fresnel block: what is reflected does not fall as light gets flatter.
void monotonic(const Block& block) {
    HardCases hard(block);
    for (int i = 0; i < hardCases / 100; ++i) {
        EvalCase request = hard.next();
        double last = 0.0;
        for (int step = 0; step <= 100; ++step) {
            request.number = 1.0 - 0.01 * step;
            const double reflected = rawValue(request)[0];
            ASSERT_GE(reflected, last - 1e-15) << described(request, {reflected}, {});
            last = reflected;
        }
    }
}

struct Claim {
    const char* name;
    void (*check)(const Block&);
};

constexpr std::array<Claim, 8> claims{{{"finite", finite},
                                       {"non_negative", nonNegative},
                                       {"reciprocal", reciprocal},
                                       {"energy_conserving", energyConserving},
                                       {"isotropic", isotropic},
                                       {"zero_below_horizon", zeroBelowHorizon},
                                       {"continuous_at_horizon", continuousAtHorizon},
                                       {"monotonic", monotonic}}};

bool makes(const Block& block, const std::string& claim) {
    return std::find(block.claims.begin(), block.claims.end(), claim) != block.claims.end();
}

class Claims : public testing::TestWithParam<std::pair<std::string, std::size_t>> {};

TEST_P(Claims, BlockThatMakesIt_KeepsIt) {
    claims[GetParam().second].check(blockNamed(GetParam().first));
}

std::vector<std::pair<std::string, std::size_t>> claimsMade() {
    std::vector<std::pair<std::string, std::size_t>> made;
    for (const std::string& name : blockNames()) {
        for (std::size_t i = 0; i < claims.size(); ++i) {
            if (makes(blockNamed(name), claims[i].name)) {
                made.emplace_back(name, i);
            }
        }
    }
    return made;
}

INSTANTIATE_TEST_SUITE_P(EveryBlock, Claims, testing::ValuesIn(claimsMade()),
                         [](const auto& tested) {
                             return testName(tested.param.first + '_' +
                                             claims[tested.param.second].name);
                         });

class FiniteOnTheGpu : public testing::TestWithParam<std::string> {};

TEST_P(FiniteOnTheGpu, BlockThatClaimsIt_KeepsIt) {
    finiteOnTheGpu(blockNamed(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(EveryBlock, FiniteOnTheGpu, testing::ValuesIn(blockNames()),
                         [](const auto& tested) { return testName(tested.param); });

TEST(Descriptors, EveryBlock_ClaimsToBeFiniteAndNotNegative) {
    for (const std::string& name : blockNames()) {
        EXPECT_TRUE(makes(blockNamed(name), "finite")) << name;
        EXPECT_TRUE(makes(blockNamed(name), "non_negative")) << name;
    }
}

TEST(Descriptors, Models_SayWhyTheyMakeNotAClaim) {
    for (const Block* model : catalog().ofKind("models")) {
        for (const Claim& claim : claims) {
            if (claim.check == monotonic) {
                continue; // of a reflectance alone
            }
            EXPECT_NE(makes(*model, claim.name), model->exemptions.contains(claim.name))
                << model->id << ' ' << claim.name;
        }
    }
}

TEST(Descriptors, FresnelBlocks_SayWhyTheyAreNotMonotonic) {
    for (const Block* block : catalog().ofKind("fresnel")) {
        EXPECT_NE(makes(*block, "monotonic"), block->exemptions.contains("monotonic")) << block->id;
    }
}

} // namespace
} // namespace patina::physics
