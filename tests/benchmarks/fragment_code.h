// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/error.h"

namespace patina::benchmarks {

/// Counts the instructions that the software driver's compiler makes of fragment shaders, by the
/// remarks of LLVM's assembly printer. A process has at most one object; once it is made, LLVM
/// writes remarks to the standard error stream until the process ends.
class FragmentCode {
  public:
    /// Needs a current context of the driver in question, without a cache of its own: programs from
    /// a cache are not compiled. It fails where LLVM does not compile the shaders, or takes no
    /// options.
    static Result<FragmentCode> create();

    /// Returns the instructions of all fragment functions that are compiled while `work` runs.
    /// Those of the loop over a block's pixels count twice, because eight of its sixteen are
    /// computed at once. 0: none were compiled.
    long instructionsOf(const std::function<void()>& work) const;

  private:
    FragmentCode() = default;
};

} // namespace patina::benchmarks
