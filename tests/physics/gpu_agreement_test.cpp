// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "cli/eval_gpu.h"
#include "cli/eval_reference.h"
#include "physics_cases.h"

namespace patina::physics {
namespace {

/// What the project promises: ordinary values agree to 1e-4 of themselves where they exceed 1e-4.
constexpr double relativeBound = 1e-4;
constexpr double smallestJudged = 1e-4;
constexpr int casesPerBlock = 100000;

/// One float rounding of a number near 1.
constexpr double floatRounding = 0x1p-24;

/// Of 100 000 cases, how many may be so close to a critical angle or the edge of a cone that a
/// rounding of their own input moves the exact answer visibly.
constexpr int mostUnsettled = 10;

/// Random values of a block and random geometry, all exact in float.
class OrdinaryCases {
  public:
    explicit OrdinaryCases(const Block& block) : block_(block) {}

    EvalCase next() {
        EvalCase request;
        request.gpu = true;
        request.block = valuesOf(block_);
        if (!block_.slots.empty()) {
            const Slot& slot = block_.slots.front();
            const auto fillers = catalog().ofKind(slot.kind);
            request.slot = valuesOf(*fillers[random_() % fillers.size()]);
        }
        placeIn(request);
        return request;
    }

  private:
    double uniform(double low, double high) {
        return std::uniform_real_distribution(low, high)(random_);
    }
    static double inFloat(double x) { return static_cast<double>(static_cast<float>(x)); }
    static glm::dvec3 inFloat(const glm::dvec3& v) { return glm::dvec3(glm::vec3(v)); }

    void placeIn(EvalCase& request) {
        const std::string& kind = block_.kind;
        if (kind == "models") {
            request.l = upperDirection();
            request.v = random_() % 3 == 0 ? nearMirror(request.l) : upperDirection();
        } else if (kind == "fresnel") {
            request.subject = EvalCase::Subject::Fresnel;
            request.number = inFloat(uniform(0.05, 1.0));
        } else if (kind == "lights") {
            request.subject = EvalCase::Subject::Light;
            request.l = inFloat({uniform(-5, 5), uniform(-5, 5), uniform(-5, 5)});
        } else {
            request.subject = EvalCase::Subject::Fog;
            request.number = inFloat(uniform(0.0, 20.0));
        }
    }

    /// A unit direction with a cosine of at least 0.05.
    glm::dvec3 upperDirection() {
        const double c = uniform(0.05, 1.0);
        const double s = std::sqrt(1.0 - c * c);
        const double phi = uniform(0.0, 2.0 * std::numbers::pi);
        return inFloat({s * std::cos(phi), s * std::sin(phi), c});
    }

    /// Where l is mirrored to, up to 0.1 off in each component.
    glm::dvec3 nearMirror(const glm::dvec3& l) {
        const glm::dvec3 off{uniform(-0.1, 0.1), uniform(-0.1, 0.1), 0.0};
        return inFloat(reference::geometry({0, 0, 1}, {1, 0, 0}, l,
                                           glm::dvec3(-l.x, -l.y, std::max(l.z, 0.05)) + off)
                           .v);
    }

    EvalBlock valuesOf(const Block& block) {
        EvalBlock result{&block, {}, {}};
        for (const Parameter& parameter : block.parameters) {
            result.values.emplace(parameter.id, valueOf(parameter));
        }
        return result;
    }

    double numberOf(const Parameter& parameter) {
        const double low = parameter.softMin;
        const double high = parameter.softMax;
        const bool log = parameter.scale == Scale::Log && low > 0.0;
        return inFloat(log ? std::exp(uniform(std::log(low), std::log(high))) : uniform(low, high));
    }

    Value valueOf(const Parameter& parameter) {
        switch (parameter.type) {
        case ParameterType::Enum:
            return parameter.values[random_() % parameter.values.size()].id;
        case ParameterType::Bool:
            return random_() % 2 == 0;
        case ParameterType::Int:
            return static_cast<int>(numberOf(parameter));
        case ParameterType::Color:
        case ParameterType::Vec3:
            return glm::dvec3(numberOf(parameter), numberOf(parameter), numberOf(parameter));
        case ParameterType::Vec2:
            return glm::dvec2(numberOf(parameter), numberOf(parameter));
        default:
            return numberOf(parameter);
        }
    }

    const Block& block_;
    std::mt19937 random_{20251121};
};

std::string described(const EvalCase& request, const std::vector<double>& exact,
                      const std::vector<double>& answer) {
    std::string text = request.block.block->id;
    const auto add = [&text](const char* name, const std::vector<double>& numbers) {
        text += std::string("\n  ") + name;
        for (const double x : numbers) {
            text += ' ' + std::to_string(x);
        }
    };
    add("parameters", request.block.packedValues());
    if (request.slot.block != nullptr) {
        add(request.slot.block->id.c_str(), request.slot.packedValues());
    }
    add("l", {request.l.x, request.l.y, request.l.z});
    add("v", {request.v.x, request.v.y, request.v.z});
    add("number", {request.number});
    add("double", exact);
    add("gpu", answer);
    return text;
}

/// The largest relative difference where it counts; infinite where a result is not finite.
double difference(const std::vector<double>& exact, const std::vector<double>& answer) {
    double worst = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        if (!std::isfinite(answer[i]) || !std::isfinite(exact[i])) {
            return HUGE_VAL;
        }
        if (std::abs(exact[i]) > smallestJudged) {
            worst = std::max(worst, std::abs(answer[i] / exact[i] - 1.0));
        }
    }
    return worst;
}

double movedBy(EvalCase request, double EvalCase::*number, const std::vector<double>& exact) {
    request.*number += floatRounding;
    return difference(exact, evaluatedInDouble(request).value());
}

double movedBy(EvalCase request, glm::dvec3 EvalCase::*vector, int component,
               const std::vector<double>& exact) {
    (request.*vector)[component] +=
        floatRounding * std::max(1.0, std::abs((request.*vector)[component]));
    return difference(exact, evaluatedInDouble(request).value());
}

/// Whether rounding the case's own inputs moves the exact answer by a good part of the bound.
bool isUnsettled(const EvalCase& request, const std::vector<double>& exact) {
    double moved = movedBy(request, &EvalCase::number, exact);
    for (int component = 0; component < 3; ++component) {
        moved += movedBy(request, &EvalCase::l, component, exact);
        moved += movedBy(request, &EvalCase::v, component, exact);
    }
    return moved > relativeBound / 8.0;
}

class GpuAgreement : public testing::TestWithParam<std::string> {};

TEST_P(GpuAgreement, RandomOrdinaryCases_MatchTheReference) {
    const std::string name = GetParam();
    const auto slash = name.find('/');
    const Block* block = catalog().find(name.substr(0, slash), name.substr(slash + 1));
    ASSERT_NE(block, nullptr);
    OrdinaryCases random(*block);
    std::vector<EvalCase> cases;
    for (int i = 0; i < casesPerBlock; ++i) {
        cases.push_back(random.next());
    }
    EvalGpu gpu;
    const auto answers = gpu.evaluate(cases, catalog());
    ASSERT_TRUE(answers.front()) << answers.front().error().text();
    int differing = 0;
    int unsettled = 0;
    double worst = 0.0;
    std::string example;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        ASSERT_TRUE(answers[i]) << answers[i].error().text();
        const std::vector<double> exact = evaluatedInDouble(cases[i]).value();
        const double error = difference(exact, *answers[i]);
        if (error >= relativeBound && isUnsettled(cases[i], exact)) {
            ++unsettled;
            continue;
        }
        differing += error < relativeBound ? 0 : 1;
        if (error > worst) {
            worst = error;
            example = described(cases[i], exact, *answers[i]);
        }
    }
    RecordProperty("worst", std::to_string(worst));
    EXPECT_LE(unsettled, mostUnsettled);
    EXPECT_EQ(differing, 0) << "worst " << worst << " in " << example;
}

std::vector<std::string> blockNames() {
    std::vector<std::string> names;
    for (const Block& block : catalog().blocks) {
        names.push_back(block.kind + '/' + block.id);
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(EveryBlock, GpuAgreement, testing::ValuesIn(blockNames()),
                         [](const auto& tested) {
                             std::string name = tested.param;
                             for (char& c : name) {
                                 c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
                             }
                             return name;
                         });

} // namespace
} // namespace patina::physics
