// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/parameter.h"

namespace patina {

/// Maps a slider's length to values. It spans the soft range and widens when a value beyond it
/// is set, up to the hard range, until it is reset.
class SliderRange {
  public:
    SliderRange() = default;
    explicit SliderRange(const Parameter& parameter);

    double lower() const { return lower_; }
    double upper() const { return upper_; }
    bool isWidenedBelow() const { return lower_ < softMin_; }
    bool isWidenedAbove() const { return upper_ > softMax_; }
    double step() const { return step_; }
    double softMin() const { return softMin_; }
    double softMax() const { return softMax_; }

    /// Makes room for a value beyond the slider, with as much again to go on.
    void widenFor(double value);
    void reset();

    /// Convert between values and positions, 0 .. 1 along the slider; what is beyond it is at its
    /// ends.
    double positionOf(double value) const;
    double valueAt(double position) const;

    /// Returns the value at a position, rounded to a power of ten that is no coarser than `span` (a
    /// share of the slider's length, such as one pixel), so that a drag gives numbers a person
    /// would type.
    double tidyValueAt(double position, double span) const;

    /// Works like tidyValueAt(), but positions go on past both ends as far as the hard range.
    double continuedValueAt(double position, double span) const;
    bool isInHardRange(double position) const;

    /// Returns the nearest value in round multiples of the step (1, 2, 5, 10, ... steps) that are
    /// at least `span` of the slider's length apart there: on a short slider single steps would not
    /// be felt.
    double snappedValueAt(double position, double span) const;

    /// Works like snappedValueAt(), but positions go on past both ends as far as the hard range.
    double continuedSnapAt(double position, double span) const;

    /// Returns a value this many steps further, inside the hard range.
    double stepped(double value, double steps) const;

    friend bool operator==(const SliderRange&, const SliderRange&) = default;

  private:
    double kneeOfLog() const;
    double continued(double position) const;
    double tidied(double value, double change) const;
    double snapped(double value, double change) const;

    double lower_ = 0.0;
    double upper_ = 1.0;
    double softMin_ = 0.0;
    double softMax_ = 1.0;
    double min_ = 0.0;
    double max_ = 1.0;
    double step_ = 0.01;
    bool isWhole_ = false;
    Scale scale_ = Scale::Linear;
};

} // namespace patina
