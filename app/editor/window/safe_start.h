// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace patina {

/// Marks in a folder, by a file that it keeps locked, that this program runs, until it ends in
/// order. A mark that nobody locks says that a program crashed or was killed.
class StartMark {
  public:
    explicit StartMark(const std::filesystem::path& folder);
    ~StartMark();
    StartMark(const StartMark&) = delete;
    StartMark& operator=(const StartMark&) = delete;

    /// Tells whether a program that ran before this one crashed or was killed.
    bool foundCrash() const { return foundCrash_; }

  private:
    std::filesystem::path mark_;
    int descriptor_ = -1; ///< holds the lock of the mark; -1 where it could not be made
    bool foundCrash_ = false;
};

/// Says why the user may want to start without what may be at fault.
enum class SafeStartReason { None, ShiftHeld, Crash };

/// Asks whether to start without the named files, unsaved work and the user's own blocks, before
/// any of them is read. Returns true for a start without them; false, without a question, where
/// there is no reason.
bool offerSafeStart(SafeStartReason reason);

} // namespace patina
