// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Makes screen readers see a ValueSlider as a slider with its real value and range. It may be
/// called any number of times.
void installValueSliderAccessibility();

} // namespace patina
