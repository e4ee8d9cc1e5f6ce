// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "measure/eval/interpreted_model.h"
#include "measure/eval/reference_case.h"
#include "measured/measured_reflectance.h"

namespace patina {

/// Evaluates a model with its values in double precision, for directions in the frame of the
/// surface: by its compiled code, or from its text where it was added or changed since the program
/// was built, which takes some fifty times as long.
class ModelValues {
  public:
    /// It is an error where there is no code and the text cannot be evaluated.
    static Result<ModelValues> of(const EvalCase& model, const Catalog& catalog);

    /// Returns the same model with the values of a case that differs in nothing that is compiled.
    ModelValues with(const EvalCase& model) const;

    /// Returns pi f cos(theta_l), 0 or more, as lights are summed; 0 where it is not finite, and
    /// everywhere once it is endless.
    glm::dvec3 at(const DirectionPair& pair) const;

    bool isCompiled() const { return compiled_ != nullptr; }

    /// Tells whether the evaluation did not end somewhere, so that its values mean nothing.
    bool isEndless() const { return isEndless_ != nullptr && *isEndless_; }

  private:
    ModelValues() = default;

    std::optional<ReferenceCode> code_;
    std::shared_ptr<const ReferenceCase> compiled_;
    std::shared_ptr<const InterpretedModel> interpreted_; ///< is null where there is code
    std::vector<double> numbers_;                         ///< are the values for it
    std::shared_ptr<std::atomic<bool>> isEndless_; ///< belongs to these values; null with code
};

} // namespace patina
