// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <QString>

#include "catalog/parameter.h"

namespace patina {

/// Returns a value as a form writes it: few digits, the unit, the label of a choice.
QString shownValue(const Parameter& parameter, const Value& value);

/// Returns what hovering over a parameter says, in plain words.
QString tooltipOf(const Parameter& parameter);

/// Returns the condition under which a parameter counts, in words: "Falloff is Polynomial".
QString enabledReason(const Parameter& parameter, std::span<const Parameter> siblings);

/// Returns the warning for a value outside the range of real things; empty when there is none.
QString physicalWarning(const Parameter& parameter, const Value& value);

} // namespace patina
