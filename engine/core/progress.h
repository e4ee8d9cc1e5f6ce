// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace patina {

/// How far long work is, and whether it is still wanted: for the thread that does it and for the
/// one that waits.
struct Progress {
    std::atomic<float> done{0.0f};      ///< 0 .. 1
    std::atomic<bool> cancelled{false}; ///< set it to stop
};

} // namespace patina
