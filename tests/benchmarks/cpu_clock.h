// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ctime>

#include "gl/driver.h"

namespace patina::benchmarks {

/// Returns seconds. On a device that is the CPU this is the time that all our threads worked, since
/// other programs on the machine hardly change it; otherwise it is wall time.
inline double workSeconds() {
    static const bool isSoftware = gl::isSoftware();
    timespec now{};
    clock_gettime(isSoftware ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

} // namespace patina::benchmarks
