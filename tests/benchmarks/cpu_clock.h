// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ctime>

#include "gl/driver.h"

namespace patina::benchmarks {

/// On a device that is the CPU, the time that all our threads worked: what else runs on the machine
/// hardly changes it. A clock on the wall otherwise.
inline double workSeconds() {
    static const bool isSoftware = gl::isSoftware();
    timespec now{};
    clock_gettime(isSoftware ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

} // namespace patina::benchmarks
