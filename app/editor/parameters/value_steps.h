// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Qt>

class QKeyEvent;
class QWheelEvent;

namespace patina {

/// Returns how many steps an arrow up or down or a page key asks for; with Shift an arrow asks for
/// a tenth. Returns nothing for other keys.
std::optional<double> stepsOf(const QKeyEvent& key);

/// Counts whole notches of a wheel, whose events may bring parts of one; with Shift each is worth
/// a tenth of a step.
class WheelSteps {
  public:
    double take(const QWheelEvent& event);
    void forget() { rest_ = 0.0; }

  private:
    double rest_ = 0.0;
};

/// Values that a drag snaps to are at least this many pixels apart: near enough for every round
/// number, far enough to be felt and hit.
inline constexpr double snapPixels = 6.0;

/// Returns the factor of a step: a tenth with Shift, else 1.
double fineness(Qt::KeyboardModifiers modifiers);

} // namespace patina
