// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string_view>
#include <vector>

namespace patina {

/// Adds up how long each pass of a frame takes, by a clock around glFinish: the device is waited
/// for after each, so the whole takes longer than a frame that is not watched.
class PassStopwatch {
  public:
    struct Lap {
        std::string_view pass; ///< is Pass::name(), or a word for what is no pass
        double milliseconds = 0.0;
    };

    /// Waits for the device and begins a lap.
    void start();
    /// Waits for the device, adds the time since the last call to a pass, and begins the next lap.
    void lap(std::string_view pass);

    /// Returns the passes in the order in which they were first drawn.
    const std::vector<Lap>& laps() const { return laps_; }

  private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point began_;
    std::vector<Lap> laps_;
};

} // namespace patina
