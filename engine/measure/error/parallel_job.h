// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>

namespace patina {

/// Does work on the elements of arrays, stage after stage, on all cores and in pieces of
/// milliseconds, so that the caller can stop at any time.
class ParallelJob {
  public:
    /// Does the elements begin .. end of a stage. It is called on several threads at once and must
    /// not throw.
    using Stage = std::function<void(std::size_t begin, std::size_t end)>;

    /// Adds a stage of so many elements, which begins when the one before is done.
    void add(std::size_t places, Stage stage);

    /// Adds a stage that is done once, on the thread that calls step().
    void addOnce(std::function<void()> work);

    /// Works for about so long, and returns true when all is done.
    bool step(std::chrono::milliseconds patience);
    void finish();

    bool isDone() const { return stages_.empty(); }

  private:
    struct Planned {
        std::size_t places = 0;
        Stage work; ///< is empty where `once` is the stage
        std::function<void()> once;
    };

    void doPiece();

    std::deque<Planned> stages_; ///< begin with the current one
    std::size_t done_ = 0;       ///< counts elements of the current one
};

} // namespace patina
