// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace patina {

/// Cuts a frame whose pixels take long into tiles of rows, each of which takes about one step's
/// time. A frame takes long if the last one with the same programs, size, triangles and rounds did;
/// any other frame counts as unknown until its time is noted.
class RowTiles {
  public:
    using Clock = std::chrono::steady_clock;

    enum class Pace {
        Quick,   ///< took little time when it was last drawn
        Unknown, ///< has not been drawn with these programs and sizes before
        Slow     ///< took longer than a window may stand still
    };

    /// Begins a frame with these programs and triangles, drawn in an image of this size, in pixels.
    /// `rounds` is how often the light of an environment is sampled.
    void begin(std::span<const void* const> programs, glm::ivec2 drawn, std::int64_t triangles,
               int rounds = 0);
    Pace pace() const;

    /// Notes the time that the current frame has taken from its beginning to its end.
    void noteTime(double milliseconds);

    bool isDone() const { return row_ >= work_.drawn.y; }

    /// Limits drawing to the next tile by the scissor test, until leave() removes the limit.
    void enter(Clock::time_point now);
    static void leave();

    /// Notes that the device has finished the tile that enter() began, and fits the height of the
    /// next one.
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
    Work known_; ///< is the frame that milliseconds_ belong to
    double milliseconds_ = 0.0;
    int row_ = 0;                              ///< is the first row that was not drawn
    int rows_ = 0;                             ///< is the height of the next tile
    std::optional<Clock::time_point> entered_; ///< is when the tile that is being drawn was begun
};

} // namespace patina
