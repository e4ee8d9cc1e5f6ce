// SPDX-License-Identifier: GPL-3.0-or-later
// How far a float result may be from the exact one, and how much work it is to say so.
#include "measure/stability/error_bound.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "physics_cases.h"

namespace patina::physics::error_bound_test {
namespace {

/// A white Lambert surface that counts how often it is asked.
class CountedModel {
  public:
    CountedModel() { model_.model = &value; }

    /// The excess of an answer that is so many roundings of float off.
    double excess(double roundings) {
        const ReferenceNumbers exact = bound().evaluate(request_);
        ReferenceNumbers answer = exact;
        answer[0] *= 1.0 + roundings * 0x1p-24;
        asked = 0;
        return limit().excess(bound(), request_, exact, answer);
    }

    double bounded() {
        const ReferenceNumbers exact = bound().evaluate(request_);
        return limit().at(bound(), request_, exact)[0] / exact[0] / 0x1p-24;
    }

    static inline int asked = 0;

  private:
    static glm::dvec3 value(const reference::Geometry& g, reference::Parameters,
                            reference::Fillers) {
        ++asked;
        return glm::dvec3(glm::dot(g.n, g.l));
    }

    static EvalCase slanting() {
        EvalCase request;
        request.block.block = catalog().find("models", "lambert");
        request.block.values = defaultValues(*request.block.block);
        request.n = {0.36, 0.48, 0.8};
        request.l = {0.0, 0.6, 0.8};
        request.v = {0.6, 0.0, 0.8};
        return request;
    }

    ErrorBound limit() const { return {code_, request_}; }
    const ReferenceCase& bound() const { return bound_; }

    reference::Block model_;
    EvalCase request_ = slanting();
    ReferenceCode code_{EvalCase::Subject::Model, &model_, nullptr};
    ReferenceCase bound_{code_, request_.block.packedValues(), {}};
};

TEST(ErrorBound, AnswerWithinTheNoise_IsSettledByAFewEvaluations) {
    CountedModel model;
    EXPECT_LE(model.excess(40.0), 1.0);
    EXPECT_GE(CountedModel::asked, 1);
    EXPECT_LE(CountedModel::asked, 8);
}

TEST(ErrorBound, AnswerBeyondTheNoise_ExceedsAllOfIt) {
    CountedModel model;
    const double roundings = 1e4;
    EXPECT_NEAR(model.excess(roundings), roundings / model.bounded(), 1e-6);
}

} // namespace
} // namespace patina::physics::error_bound_test
