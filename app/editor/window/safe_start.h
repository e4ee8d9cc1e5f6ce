// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace patina {

/// Marks in a folder that this program runs, until it ends in order. What an earlier one left there
/// says that it crashed or was killed.
class StartMark {
  public:
    explicit StartMark(const std::filesystem::path& folder);
    ~StartMark();
    StartMark(const StartMark&) = delete;
    StartMark& operator=(const StartMark&) = delete;

    /// Tells whether an earlier program did not end in order since the last start.
    bool foundCrash() const { return foundCrash_; }

  private:
    std::filesystem::path mark_; ///< empty: it could not be made
    bool foundCrash_ = false;
};

/// Says why somebody may want to start without what may be at fault.
enum class SafeStartReason { None, ShiftHeld, Crash };

/// Asks whether to begin without the files that were named, unsaved work and the user's own blocks,
/// before any of them is read. True: without them.
bool offerSafeStart(SafeStartReason reason);

} // namespace patina
