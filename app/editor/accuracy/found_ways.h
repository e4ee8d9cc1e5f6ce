// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include <QString>

#include "background/worker.h"
#include "docks/measure_end.h"
#include "measure/approximation/approximated_block.h"
#include "measure/approximation/frame_check.h"

namespace patina {

/// Says what a search for cheaper ways is of.
struct WaysWish {
    std::shared_ptr<const Catalog> catalog;
    EvalCase subject; ///< has a block of the catalogue
    CheaperSearchOptions options;
    std::filesystem::path folder; ///< is that of the user's blocks; empty where there is none
    CostSweep::Subject shown;     ///< is what is on screen, whose object has the block
};

/// Holds what a search has found, with the blocks that it is of.
struct FoundWays {
    WaysWish wish;
    CheaperWays ways;
    ApproximatedBlock block; ///< is what would be saved
    bool isChecked = false;  ///< errors are those on unseen cases and on the graphics device
    std::optional<WaysInFrame> inFrame; ///< is empty until what is on screen was drawn with them
    std::uint64_t shader = 0;           ///< is the hash of the block's GLSL file that was searched
};

/// Returns the hash of a file's text; 0 where it cannot be read.
std::uint64_t textHash(const std::filesystem::path& file);

/// Searches in a worker's thread, whose context must be current, and passes what it has to `take`
/// in the window's thread whenever there is more. Where `isEnough` becomes true it ends with what
/// it has found, checked; cancelled it ends at once.
MeasureEnd findWays(const WaysWish& wish, const std::atomic<bool>& isEnough,
                    Worker::Control& control, const std::function<void(const FoundWays&)>& take);

/// Writes the found ways as a block of their own into the user's folder, under an id that nothing
/// there has, and returns its id. It is an error where they are not checked, there is no such
/// folder, the searched shader has changed since, or the files cannot be written.
Result<std::string> savedWays(const FoundWays& found, const Catalog& catalog);

/// Says how errors and costs were found.
QString methodText(const FoundWays& found);

/// Returns the entry of the descriptor's "accuracy" as JSON.
QString entryText(const FoundWays& found);

} // namespace patina
