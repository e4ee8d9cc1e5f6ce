// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace patina {

/// Says how far long work is, and whether it is still wanted. It is shared by the thread that does
/// the work and the one that waits.
struct Progress {
    std::atomic<float> done{0.0f};      ///< 0 .. 1
    std::atomic<bool> cancelled{false}; ///< set it to stop
};

} // namespace patina
