// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>

namespace patina {

/// Work on the places of arrays, stage after stage, on all cores and in pieces of milliseconds: who
/// wants it no more stops asking.
class ParallelJob {
  public:
    /// Does the places begin .. end of a stage. Called on several threads at once; must not throw.
    using Stage = std::function<void(std::size_t begin, std::size_t end)>;

    /// A stage begins when all places of the one before are done.
    void add(std::size_t places, Stage stage);

    /// Adds what is done once, on the thread that asks.
    void addOnce(std::function<void()> work);

    /// Works for about so long; true when all is done.
    bool step(std::chrono::milliseconds patience);
    void finish();

    bool isDone() const { return stages_.empty(); }

  private:
    struct Planned {
        std::size_t places = 0;
        Stage work; ///< empty: `once`
        std::function<void()> once;
    };

    void doPiece();

    std::deque<Planned> stages_; ///< the current one first
    std::size_t done_ = 0;       ///< places of the current one
};

} // namespace patina
