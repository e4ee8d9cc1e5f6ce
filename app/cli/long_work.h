// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace patina {

/// Lets Ctrl-C stop work that may take minutes: the first press asks it to stop, so that what is
/// done by then can be shown; the second ends the program at once. Only one may exist at a time.
class LongWork {
  public:
    LongWork();
    ~LongWork();
    LongWork(const LongWork&) = delete;
    LongWork& operator=(const LongWork&) = delete;

    bool isStopped() const;

    /// Writes the progress to standard error over the text before; only where that is a terminal.
    void report(const std::string& text);

    /// Is the exit status that shells expect of a program that Ctrl-C has ended.
    static constexpr int stoppedStatus = 130;

  private:
    void (*before_)(int);
    bool isWatched_;
};

} // namespace patina
