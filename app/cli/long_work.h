// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace patina {

/// Work that may take minutes, of which there is one at a time: Ctrl-C asks for its end, so that
/// what is done by then can be shown; pressed again it ends the program at once.
class LongWork {
  public:
    LongWork();
    ~LongWork();
    LongWork(const LongWork&) = delete;
    LongWork& operator=(const LongWork&) = delete;

    bool isStopped() const;

    /// Writes how far it is over what was told before; only where somebody watches.
    void tell(const std::string& text);

    /// The status of a program that Ctrl-C has ended, as shells have it.
    static constexpr int stoppedStatus = 130;

  private:
    void (*before_)(int);
    bool isWatched_;
};

} // namespace patina
