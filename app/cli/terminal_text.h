// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <streambuf>

namespace patina {

/// Hands text on to another buffer with question marks in place of control characters, but for line
/// breaks and tabs. Tables quote names from files that nobody vouches for, and a terminal obeys
/// control characters: it changes its title, its colours, or what is typed next.
class TerminalText : public std::streambuf {
  public:
    explicit TerminalText(std::streambuf& terminal) : terminal_(terminal) {}

  protected:
    int_type overflow(int_type character) override;
    int sync() override { return terminal_.pubsync(); }

  private:
    std::streambuf& terminal_;
};

/// Sends what standard output gets through TerminalText for as long as it lives, where a terminal
/// shows it; files and other programs get every byte.
class TerminalGuard {
  public:
    TerminalGuard();
    ~TerminalGuard();
    TerminalGuard(const TerminalGuard&) = delete;
    TerminalGuard& operator=(const TerminalGuard&) = delete;

  private:
    std::streambuf* plain_;
    TerminalText text_;
};

} // namespace patina
