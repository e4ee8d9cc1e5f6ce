// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/row_tiles.h"

#include <algorithm>

#include <epoxy/gl.h>

namespace patina {
namespace {

constexpr double longestMs = 100.0; ///< is how long a window may stand still
constexpr double tileMs = 15.0;
constexpr double firstRows = 4.0; ///< is the height of a tile while the time is unknown
constexpr int minRows = 4;        ///< also divides each height, so that no quad of pixels is cut
constexpr double maxRows = 65536.0;
constexpr double maxGrowth = 4.0; ///< limits the growth from tile to tile, since the next rows may
                                  ///< take longer

int whole(double rows) {
    return static_cast<int>(std::clamp(rows, 1.0 * minRows, maxRows)) / minRows * minRows;
}

} // namespace

void RowTiles::begin(std::span<const void* const> programs, glm::ivec2 drawn,
                     std::int64_t triangles, int rounds) {
    work_.programs.assign(programs.begin(), programs.end());
    work_.drawn = drawn;
    work_.triangles = triangles;
    work_.rounds = rounds;
    row_ = 0;
    const double rows = isKnown() ? drawn.y * tileMs / milliseconds_ : firstRows;
    rows_ = whole(rows);
    entered_.reset();
}

bool RowTiles::isKnown() const {
    return milliseconds_ > 0.0 && work_.programs == known_.programs &&
           work_.drawn == known_.drawn && work_.triangles == known_.triangles &&
           work_.rounds == known_.rounds;
}

RowTiles::Pace RowTiles::pace() const {
    if (!isKnown()) {
        return Pace::Unknown;
    }
    return milliseconds_ > longestMs ? Pace::Slow : Pace::Quick;
}

void RowTiles::noteTime(double milliseconds) {
    if (!isKnown()) {
        known_.programs.assign(work_.programs.begin(), work_.programs.end());
        known_.drawn = work_.drawn;
        known_.triangles = work_.triangles;
        known_.rounds = work_.rounds;
    }
    milliseconds_ = milliseconds;
}

void RowTiles::enter(Clock::time_point now) {
    entered_ = now;
    rows_ = std::min(rows_, work_.drawn.y - row_);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, row_, work_.drawn.x, rows_);
    row_ += rows_;
}

void RowTiles::leave() {
    glDisable(GL_SCISSOR_TEST);
}

void RowTiles::passed(Clock::time_point now) {
    if (!entered_) {
        return;
    }
    const std::chrono::duration<double, std::milli> taken = now - *entered_;
    entered_.reset();
    rows_ = whole(rows_ * std::min(tileMs / std::max(taken.count(), 1e-3), maxGrowth));
}

} // namespace patina
