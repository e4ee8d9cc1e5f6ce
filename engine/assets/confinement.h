// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include <sys/types.h>

namespace patina {

/// Holds the limits, in bytes, of a process that works on untrusted files. A limit that is empty is
/// inherited from this process.
struct Confinement {
    std::optional<std::size_t> addressSpace{};
    /// Limits private writable memory. It suits graphics drivers, which reserve far more addresses
    /// than they ever use.
    std::optional<std::size_t> data{};
    std::optional<std::size_t> stack{};
    bool isQuiet = false; ///< sends standard error to standard output, except under a sanitizer
};

/// Limits the new process before its program starts. The process dies with the thread of `parent`
/// that started it, writes no core file, and inherits no open file but the standard ones. It calls
/// only functions that are safe after a fork.
void confine(const Confinement& limits, pid_t parent);

} // namespace patina
