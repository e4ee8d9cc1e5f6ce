// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "measure/time/instruction_count.h"
#include "measure/time/timed_frames.h"

namespace patina {

/// Returns the instructions of the program that draws an object of the scene; nothing where its
/// text cannot be put together or counted.
std::optional<InstructionCount> surfaceInstructions(const Scene& scene, std::size_t object,
                                                    const Camera& camera,
                                                    const TimedFrames::Supplies& supplies);

} // namespace patina
