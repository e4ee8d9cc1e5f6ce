// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/cost/sweep_frames.h"
#include "measure/time/timed_frames.h"

namespace patina {

/// Estimates how many seconds all single choices of a picture will take, from a frame with few
/// directions of an environment. Returns 0 for a material, or where frames have few directions
/// anyway.
double secondsOfSingles(const SweepFrames& frames, TimedFrames& drawn);

} // namespace patina
