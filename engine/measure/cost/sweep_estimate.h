// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/cost/sweep_frames.h"
#include "measure/time/timed_frames.h"

namespace patina {

/// Returns how long all single choices of a picture will take, about, where frames have hundreds of
/// directions of an environment: a few of them tell. 0: that is not known before.
double secondsOfSingles(const SweepFrames& frames, TimedFrames& drawn);

} // namespace patina
