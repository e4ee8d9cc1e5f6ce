// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/error.h"

namespace patina::benchmarks {

/// Counts the instructions that the software driver's compiler makes of fragment shaders, by the
/// remarks of LLVM's assembly printer. A process has at most one, from which on LLVM writes remarks
/// to the standard error stream until the process ends.
class FragmentCode {
  public:
    /// With the context current whose driver is asked, and that has no cache of its own: what comes
    /// from there is not compiled. Fails where no LLVM compiles shaders, or it takes no options.
    static Result<FragmentCode> create();

    /// Instructions of all fragment functions that are compiled while `work` runs, those of the
    /// loop over a block's pixels twice: eight of its sixteen are computed at once. 0: there were
    /// none.
    long instructionsOf(const std::function<void()>& work) const;

  private:
    FragmentCode() = default;
};

} // namespace patina::benchmarks
