// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "measure/eval/reference_case.h"
#include "measured/measured_reflectance.h"

namespace patina {

/// Evaluates a model with its values in double precision, for directions in the frame of the
/// surface.
class ModelValues {
  public:
    /// It is an error where a block has no code in double precision.
    static Result<ModelValues> of(const EvalCase& model);

    /// Returns pi f cos(theta_l), 0 or more, as lights are summed; 0 where it is not finite.
    glm::dvec3 at(const DirectionPair& pair) const;

  private:
    explicit ModelValues(std::shared_ptr<const ReferenceCase> model) : model_(std::move(model)) {}

    std::shared_ptr<const ReferenceCase> model_;
};

} // namespace patina
