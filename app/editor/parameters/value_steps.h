// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Qt>

class QKeyEvent;
class QWheelEvent;

namespace patina {

/// Returns how many steps an arrow up or down or a page key asks for; with Shift an arrow asks for
/// a tenth. Nothing for other keys.
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

/// So far apart, in pixels of a drag, are the values it snaps to at least: near enough for every
/// round number, far enough to be felt and hit.
inline constexpr double snapPixels = 6.0;

/// Returns what Shift makes of a step.
double fineness(Qt::KeyboardModifiers modifiers);

} // namespace patina
