// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/choice/choices.h"
#include "measure/cost/cost_sweep.h"

namespace patina {

/// Describes the frames of a sweep: what is drawn for a point of its chart.
class SweepFrames {
  public:
    /// Takes a sweep's subject and removes from its scene what is not measured.
    SweepFrames(CostSweep::Subject subject, const CostSweep::Options& options, glm::ivec2 size);

    /// Returns what can be computed more cheaply, as far as the options ask for it.
    const std::vector<Choice>& choices() const { return choices_; }
    bool isOfMaterial() const { return scope_ == Choice::Scope::Material; }
    const CostSweep::Subject& subject() const { return subject_; }
    const std::vector<bool>& counted() const {
        return counted_;
    } ///< tells for each object whether it is measured

    /// Returns the frame of these levels as it is timed.
    ChosenFrame of(const ChosenLevels& levels) const;

    /// Returns the frame of these levels as it is captured. For a material it has 32-bit floats and
    /// few directions of an environment; for a picture it is the frame that is timed, behind the
    /// passes where a level is of one.
    ChosenFrame captured(const ChosenLevels& levels) const;

    /// Returns the exact frame without the objects that are measured, and of a picture without its
    /// passes.
    ChosenFrame empty() const;

  private:
    CostSweep::Subject subject_;
    Choice::Scope scope_;
    glm::ivec2 size_;
    std::vector<Choice> choices_;
    std::vector<bool> counted_;
};

} // namespace patina
