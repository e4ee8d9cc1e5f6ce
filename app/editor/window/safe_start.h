// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace patina {

/// Marks in a folder, by a file with its process number, that this program runs, until it ends in
/// order. The mark of a process that no longer runs says that it crashed or was killed.
class StartMark {
  public:
    explicit StartMark(const std::filesystem::path& folder);
    ~StartMark();
    StartMark(const StartMark&) = delete;
    StartMark& operator=(const StartMark&) = delete;

    /// Tells whether a program that ran before this one crashed or was killed.
    bool foundCrash() const { return foundCrash_; }

  private:
    std::filesystem::path mark_; ///< is empty where the file could not be made
    bool foundCrash_ = false;
};

/// Says why the user may want to start without what may be at fault.
enum class SafeStartReason { None, ShiftHeld, Crash };

/// Asks whether to start without the named files, unsaved work and the user's own blocks, before
/// any of them is read. Returns true for a start without them; false, without a question, where
/// there is no reason.
bool offerSafeStart(SafeStartReason reason);

} // namespace patina
