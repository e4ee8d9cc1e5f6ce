// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "measure/eval/eval_case.h"

namespace patina {

/// Tells whether a parameter counts as the block's choices stand (Parameter::enabledWhen). A
/// condition on a number that a fit may change is taken as met.
bool counts(const Parameter& parameter, const EvalBlock& block);

/// Lists the numbers of a model, and of what fills its slot, that a fit may change: those of
/// parameters with a continuous range that count as the choices stand. Choices, switches, images,
/// functions and what is emitted stay. A number is counted in lengths of its slider, from 0 at the
/// slider's start to 1 at its end, on the slider's scale; typed ranges may go beyond.
class FreeNumbers {
  public:
    /// With ids in `only`, as FitOptions has them, only those may change.
    explicit FreeNumbers(const EvalCase& model, const std::vector<std::string>& only = {});

    std::size_t size() const { return numbers_.size(); }
    double min(std::size_t index) const { return numbers_[index].min; }
    double max(std::size_t index) const { return numbers_[index].max; }
    /// Tells whether two numbers are of one parameter, as those of a colour.
    bool areOfOne(std::size_t a, std::size_t b) const {
        return numbers_[a].parameter == numbers_[b].parameter;
    }

    /// Returns the id of the parameter that a number is of.
    const std::string& parameter(std::size_t index) const { return numbers_[index].parameter->id; }

    std::vector<double> of(const EvalCase& model) const;

    /// Sets all numbers of a case that has the blocks of the one this was made for.
    void set(EvalCase& model, const double* values) const;

  private:
    struct Number {
        bool isOfSlot = false;
        const Parameter* parameter = nullptr;
        int component = 0;
        double min = 0.0;
        double max = 1.0;
    };

    void add(const EvalBlock& block, bool isOfSlot, const std::vector<std::string>& only);

    std::vector<Number> numbers_;
};

} // namespace patina
