// SPDX-License-Identifier: GPL-3.0-or-later
// Every promise a descriptor makes, tested on every block that makes it, in double precision and in
// the real shader; every promise that a descriptor says it cannot make, shown to be false.
#include <gtest/gtest.h>

#include <limits>

#include "claim_checks.h"
#include "measure/eval/eval_gpu.h"
#include "reference_codes.h"

namespace patina::physics::claims_test {
namespace {

/// Two values of the shader are each within 1e-4 of theirs, as tests of its agreement show.
constexpr Care onTheGpu{2e-4, 1e-6, 20000, 4000, 1 << 15};
constexpr Care inDouble{};

Evaluate inDoublePrecision() {
    return [codes = ReferenceCodes()](const std::vector<Trial>& trials) mutable {
        std::vector<Numbers> values;
        for (const auto& [request, places] : trials) {
            const bool slotted = request.slot.block != nullptr;
            const ReferenceCase bound(codes.of(request), request.block.packedValues(),
                                      slotted ? request.slot.packedValues() : Numbers());
            for (const EvalPlace& place : places) {
                const ReferenceNumbers numbers = bound.evaluate(place);
                values.emplace_back(numbers.begin(), numbers.begin() + resultsOf(request));
            }
        }
        return values;
    };
}

/// In float on the graphics device, where subnormals are flushed and built-in functions are coarse.
Evaluate shader() {
    return [gpu = std::make_shared<EvalGpu>()](const std::vector<Trial>& trials) {
        std::vector<EvalCase> cases;
        for (const auto& [request, places] : trials) {
            for (const EvalPlace& place : places) {
                cases.push_back(request);
                static_cast<EvalPlace&>(cases.back()) = place;
            }
        }
        std::vector<Numbers> values;
        for (const auto& answer : gpu->evaluate(cases, catalog())) {
            values.push_back(answer.value());
        }
        return values;
    };
}

bool makes(const Block& block, const std::string& claim) {
    return std::find(block.claims.begin(), block.claims.end(), claim) != block.claims.end();
}

/// A block's name and the place of a claim in the list.
using Made = std::pair<std::string, std::size_t>;

std::string nameOf(const testing::TestParamInfo<Made>& tested) {
    return testName(tested.param.first + '_' + claims[tested.param.second].name);
}

template <class Wanted>
std::vector<Made> blocksAndClaims(Wanted wanted) {
    std::vector<Made> found;
    for (const std::string& name : blockNames()) {
        for (std::size_t i = 0; i < claims.size(); ++i) {
            if (wanted(blockNamed(name), claims[i])) {
                found.emplace_back(name, i);
            }
        }
    }
    return found;
}

std::optional<std::string> tried(const Made& made, const Care& care, const Evaluate& evaluate) {
    const Experiment experiment = claims[made.second].experiment(blockNamed(made.first), care);
    return counterexample(experiment, evaluate);
}

class Claims : public testing::TestWithParam<Made> {};

TEST_P(Claims, BlockThatMakesIt_KeepsIt) {
    const auto broken = tried(GetParam(), inDouble, inDoublePrecision());
    EXPECT_FALSE(broken) << *broken;
}

INSTANTIATE_TEST_SUITE_P(EveryBlock, Claims,
                         testing::ValuesIn(blocksAndClaims([](const Block& block, const Claim& c) {
                             return makes(block, c.name);
                         })),
                         nameOf);

/// The sweep of the edge cases looks for what is negative or below the horizon.
class ClaimsOnTheGpu : public testing::TestWithParam<Made> {};

TEST_P(ClaimsOnTheGpu, BlockThatMakesIt_KeepsIt) {
    const auto broken = tried(GetParam(), onTheGpu, shader());
    EXPECT_FALSE(broken) << *broken;
}

INSTANTIATE_TEST_SUITE_P(EveryBlock, ClaimsOnTheGpu,
                         testing::ValuesIn(blocksAndClaims([](const Block& block, const Claim& c) {
                             return makes(block, c.name) && c.experiment != nonNegative &&
                                    c.experiment != zeroBelowHorizon;
                         })),
                         nameOf);

/// Exemptions whose cases chance does not meet: a light along the ridges, a steep lobe that ends at
/// the horizon, light below 3 degrees (on a smooth white base of glTF, too), a sharp glow, half of
/// whose forms keep it, and files of surfaces: RareExemptions and MeasuredGrain have a case of
/// each. A grating keeps its energy (grating_test.cpp), but coarse rules miss its lines or hit
/// them.
bool isRare(const Block& block, const Claim& claim) {
    const std::string name = block.id + ' ' + claim.name;
    return name == "poulin-fournier continuous_at_horizon" ||
           name == "lafortune continuous_at_horizon" || name == "strauss energy_conserving" ||
           name == "metallic-roughness energy_conserving" ||
           name == "measured energy_conserving" || name == "measured-grain energy_conserving" ||
           (block.kind == "specular" && name == "schlick energy_conserving") ||
           name == "measured-grain isotropic" || name == "grating energy_conserving";
}

class Exemptions : public testing::TestWithParam<Made> {};

TEST_P(Exemptions, ClaimThatIsNotMade_IsFalse) {
    EXPECT_TRUE(tried(GetParam(), inDouble, inDoublePrecision())) << "could be claimed";
}

INSTANTIATE_TEST_SUITE_P(EveryBlock, Exemptions,
                         testing::ValuesIn(blocksAndClaims([](const Block& block, const Claim& c) {
                             return block.exemptions.contains(c.name) && !isRare(block, c);
                         })),
                         nameOf);

/// One wrong answer among a hundred.
Evaluate wrongOnce(double wrong) {
    return [wrong](const std::vector<Trial>& trials) {
        std::vector<Numbers> values(trials.size(), Numbers(3, 0.5));
        values[99][2] = wrong;
        return values;
    };
}

TEST(FiniteClaim, OneNaN_IsFound) {
    const Evaluate wrong = wrongOnce(std::numeric_limits<double>::quiet_NaN());
    EXPECT_TRUE(counterexample(finite(blockNamed("models/lambert"), inDouble), wrong));
}

TEST(FiniteClaim, OneInfinity_IsFound) {
    const Evaluate wrong = wrongOnce(std::numeric_limits<double>::infinity());
    EXPECT_TRUE(counterexample(finite(blockNamed("models/lambert"), inDouble), wrong));
}

TEST(NonNegativeClaim, OneNegativeValue_IsFound) {
    const Evaluate wrong = wrongOnce(-1e-300);
    EXPECT_TRUE(counterexample(nonNegative(blockNamed("models/lambert"), inDouble), wrong));
}

TEST(Descriptors, EveryBlock_ClaimsToBeFiniteAndNotNegative) {
    for (const std::string& name : blockNames()) {
        EXPECT_TRUE(makes(blockNamed(name), "finite")) << name;
        EXPECT_TRUE(makes(blockNamed(name), "non_negative")) << name;
    }
}

TEST(Descriptors, Models_SayWhyTheyMakeNotAClaim) {
    for (const Block* model : catalog().ofKind("models")) {
        for (const Claim& claim : claims) {
            if (claim.experiment == monotonic) {
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
} // namespace patina::physics::claims_test
