// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include <sys/types.h>

namespace patina {

/// Holds what a process may have that works on files of strangers, in bytes; nothing: as much as
/// this one.
struct Confinement {
    std::optional<std::size_t> addressSpace{};
    /// Memory that only it may write. Drivers reserve far more addresses than they ever use.
    std::optional<std::size_t> data{};
    std::optional<std::size_t> stack{};
    bool isQuiet = false; ///< standard error leads to standard output; a sanitizer's stays
};

/// Runs in the new process before its program starts: it dies with its parent's thread, leaves no
/// core, and takes no open file along but its standard ones. Calls only what is safe after a fork.
void confine(const Confinement& limits, pid_t parent);

} // namespace patina
