// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace patina {

/// Cuts a frame whose pixels take long into tiles of rows, each as high as a step may take, and
/// knows which frames that are: those that took long the last time. One whose programs, size,
/// triangles or rounds were not the last one's is watched until its time is known.
class RowTiles {
  public:
    using Clock = std::chrono::steady_clock;

    enum class Pace {
        Quick,   ///< took little the last time
        Unknown, ///< may take little
        Slow     ///< took more than a window should wait
    };

    /// Begins a new frame: what it is made of, the rows of the image that it is drawn in, and how
    /// many times over an environment's light is looked at.
    void begin(std::span<const void* const> programs, glm::ivec2 drawn, std::int64_t triangles,
               int rounds = 0);
    Pace pace() const;

    /// Notes what the frame that was begun has taken, from its beginning to its end.
    void noteTime(double milliseconds);

    bool isDone() const { return row_ >= work_.drawn.y; }

    /// Lets only the next tile be drawn; leave() lets everything be drawn again.
    void enter(Clock::time_point now);
    static void leave();

    /// The device is done with the tiles so far.
    void passed(Clock::time_point now);

  private:
    struct Work {
        std::vector<const void*> programs;
        glm::ivec2 drawn{0};
        std::int64_t triangles = 0;
        int rounds = 0;
    };

    bool isKnown() const;

    Work work_;
    Work known_; ///< what milliseconds_ are of
    double milliseconds_ = 0.0;
    int row_ = 0;                              ///< the first one that was not drawn
    int rows_ = 0;                             ///< of the next tile
    std::optional<Clock::time_point> entered_; ///< the tile that is being drawn
};

} // namespace patina
