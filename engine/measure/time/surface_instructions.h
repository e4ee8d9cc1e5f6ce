// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "measure/time/instruction_count.h"
#include "measure/time/timed_frames.h"

namespace patina {

/// Counts the instructions of the program that draws an object of the scene; nothing is returned
/// where its text cannot be built or counted, or a block in it is not let in.
std::optional<InstructionCount> surfaceInstructions(const Scene& scene, std::size_t object,
                                                    const Camera& camera,
                                                    const TimedFrames::Supplies& supplies);

} // namespace patina
