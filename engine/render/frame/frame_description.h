// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "render/pass/frame_gpu.h"
#include "render/pass/program_pass.h"

namespace patina {

/// Tells what a frame was made of, as its report says it. Effects and messages are put into words
/// again only where they are not those of the last frame.
class FrameDescription {
  public:
    /// Fills the report of a frame that is drawn.
    void write(const FramePlan& plan, FrameGpu& gpu, ProgramPass& programs,
               const std::optional<Error>& shadowError);

    /// Writes only the error why there is no frame.
    void writeFailure(FrameReport& report, const Error& error);

    /// Everything is put into words the next time.
    void forget() { sources_.reset(); }

  private:
    void countPrograms(const FramePlan& plan, FrameReport& report);
    static void writeEffects(const FramePlan& plan, FrameGpu& gpu, ProgramPass& programs);
    void writeLost(FrameReport& report) const;

    std::vector<const void*> programs_;
    std::optional<std::vector<const void*>> sources_; ///< what the words are made from, and:
    int lostLights_ = 0;
    int lostShadows_ = 0;
    std::optional<Error> shadowError_;
};

} // namespace patina
