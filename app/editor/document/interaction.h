// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "document/document_state.h"

namespace patina {

/// Says whether an interaction (a drag, a held key) is going on, which is one undo step: every edit
/// between begin() and end() merges, and one that ends where it began leaves no step.
class Interaction {
  public:
    /// Calls `announce` whenever one began or ended.
    explicit Interaction(std::function<void()> announce);

    /// Begins one, which ends the one before, and returns its token. `dragged` is the value that it
    /// changes, where that is a single one.
    int begin(std::optional<ParameterTarget> dragged = std::nullopt);

    /// Ends the one of a token, and does nothing where another one has begun since; 0 ends
    /// whichever is going on.
    void end(int token = 0);

    /// Drops the one that is going on, where another scene is opened. Announces nothing.
    void drop();

    bool isGoingOn() const { return token_ != 0; }
    int token() const { return token_; } ///< 0: none is going on
    const std::optional<ParameterTarget>& dragged() const { return dragged_; }

  private:
    std::function<void()> announce_;
    int token_ = 0;
    int lastToken_ = 0;
    std::optional<ParameterTarget> dragged_;
};

} // namespace patina
