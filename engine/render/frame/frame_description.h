// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "render/pass/frame_gpu.h"
#include "render/pass/program_pass.h"

namespace patina {

/// Writes the report of a frame. Effects and messages are written again only when they differ from
/// those of the last frame.
class FrameDescription {
  public:
    /// Fills the report of a frame that is drawn.
    void write(const PreparedFrame& frame, FrameGpu& gpu, ProgramPass& programs,
               const std::optional<Error>& shadowError);

    /// Writes an error as the only message, for a frame that could not be drawn.
    void writeFailure(FrameReport& report, const Error& error);

    /// Makes the next write() write everything again.
    void forget() { sources_.reset(); }

  private:
    void countPrograms(const PreparedFrame& frame, FrameReport& report);
    static void writeEffects(const PreparedFrame& frame, FrameGpu& gpu, ProgramPass& programs);
    void writeLost(FrameReport& report) const;

    std::vector<const void*> programs_;
    std::optional<std::vector<const void*>> sources_; ///< has FramePlan::sources of the last
                                                      ///< report; empty after forget()
    int lostLights_ = 0;
    int lostShadows_ = 0;
    std::optional<Error> shadowError_;
};

} // namespace patina
