// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>

#include "accuracy/measured_subject.h"
#include "measure/choice/choices.h"

namespace patina {

/// Is what the points of a chart are measured of and given to: a material or the picture.
class ChartTarget {
  public:
    virtual ~ChartTarget() = default;

    virtual Choice::Scope scope() const = 0;

    /// Returns what of it can be computed more cheaply now.
    virtual std::vector<Choice> choices() const = 0;

    /// Returns what it has of these, without what is exact.
    virtual ChosenLevels levels(const std::vector<Choice>& choices) const = 0;

    /// Returns what a chart of now is of. It is of all choices, so which of them are taken makes no
    /// difference to it.
    virtual MeasuredSubject subject() const = 0;

    /// Gives it these levels, and of the other choices the exact ones, as one undo step.
    virtual void apply(const std::vector<Choice>& choices, const ChosenLevels& levels,
                       const QString& label) = 0;

    /// Shows the exact way in A and these levels in B, as one undo step, and the difference beside,
    /// until comparing ends: nothing is chosen by it.
    virtual void compare(const std::vector<Choice>& choices, const ChosenLevels& levels) = 0;

    virtual QString measureText() const = 0;   ///< what measuring does, for a tool tip
    virtual QString noChoicesText() const = 0; ///< that there is nothing to choose
};

} // namespace patina
