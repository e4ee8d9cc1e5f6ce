// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "measure/time/timed_frames.h"

namespace patina {

/// Measures one object in scene after scene, as a contact sheet shows them: the time of a frame,
/// and its error against the exact one. It must be made, used and destroyed with the same context
/// current.
class CellMeter {
  public:
    static Result<std::unique_ptr<CellMeter>> create(TimedFrames::Supplies supplies,
                                                     std::filesystem::path programCache);

    /// Says what is measured. The scene and the meshes must not change meanwhile.
    struct Subject {
        const Scene& scene;
        std::size_t object = 0;
        std::shared_ptr<const EnvironmentImage> environment{};
    };

    /// Returns the milliseconds of a frame of timedSize(): the median of a few, after one that only
    /// warms up.
    Result<double> milliseconds(const Subject& subject);
    std::string method() const { return frames_->method(); }

    /// Returns the relative error that 99 of 100 pixels of the object keep, against the same
    /// picture of `size` pixels with every accuracy choice exact: in double precision where that is
    /// possible, else as the device draws it. Calls `isCancelled` every 20 milliseconds or so, and
    /// returns an error once that is true.
    Result<double> error(const Subject& subject, glm::ivec2 size,
                         const std::function<bool()>& isCancelled = {});

  private:
    CellMeter(TimedFrames::Supplies supplies, std::unique_ptr<TimedFrames> frames);

    TimedFrames::Supplies supplies_;
    std::unique_ptr<TimedFrames> frames_;
};

} // namespace patina
