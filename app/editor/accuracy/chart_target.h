// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>

#include "accuracy/measured_subject.h"
#include "measure/choice/choices.h"

namespace patina {

/// Is what a chart measures and what its points are applied to: a material or the picture.
class ChartTarget {
  public:
    virtual ~ChartTarget() = default;

    virtual Choice::Scope scope() const = 0;

    /// Returns what can be computed at another level than the exact one now.
    virtual std::vector<Choice> choices() const = 0;

    /// Returns the levels that the target has now, without exact ones.
    virtual ChosenLevels levels(const std::vector<Choice>& choices) const = 0;

    /// Returns the subject of a chart that would be measured now. Since a chart covers all choices,
    /// the subject does not depend on the levels that are chosen.
    virtual MeasuredSubject subject() const = 0;

    /// Applies these levels, and the exact one to every other choice, as one undo step.
    virtual void apply(const std::vector<Choice>& choices, const ChosenLevels& levels,
                       const QString& label) = 0;

    /// Shows the exact levels in A, these levels in B and the difference beside them, as one undo
    /// step, until the comparison ends. The target keeps its levels.
    virtual void compare(const std::vector<Choice>& choices, const ChosenLevels& levels) = 0;

    virtual QString measureText() const = 0;   ///< says what measuring does, for a tool tip
    virtual QString noChoicesText() const = 0; ///< says that there is nothing to choose
};

} // namespace patina
