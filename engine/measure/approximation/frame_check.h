// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "measure/approximation/cheaper_ways.h"
#include "measure/cost/cost_sweep.h"
#include "measure/error/frame_error.h"
#include "measure/time/choice_cost.h"

namespace patina {

/// Is what a found way is in the frame of a material.
struct WayInFrame {
    FrameError error;
    ChoiceCost cost; ///< is beside the material as it is
};

/// Holds what found ways are in the frame of a material.
struct WaysInFrame {
    std::string groundTruth;      ///< says with what frames are compared, for users
    std::string timer;            ///< says how frames were timed, for users
    glm::ivec2 errorSize{0};      ///< are the pixels of the frames that are compared
    glm::ivec2 timedSize{0};      ///< are those of the frames that are timed
    double milliseconds = 0.0;    ///< is the time of the frame with the material as it is
    std::vector<WayInFrame> ways; ///< are in the order of those that were found
};

/// Draws the subject's object with its material and with each of the ways, and compares the frames
/// with one in double precision, where the CPU can compute it; then times them in turn for about so
/// long. `searched` is the case that the ways were found for, of a block that the material has as
/// its model or as a part. A context must be current. It is an error where the frame cannot be
/// drawn, and where it is stopped.
Checked<WaysInFrame> waysInFrame(const CostSweep::Subject& subject, const EvalCase& searched,
                                 const CheaperWays& ways, const std::filesystem::path& shaders,
                                 double seconds, const std::function<bool()>& isStopped);

} // namespace patina
