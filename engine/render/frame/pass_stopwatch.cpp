// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/frame/pass_stopwatch.h"

#include <algorithm>

#include <epoxy/gl.h>

namespace patina {

void PassStopwatch::start() {
    glFinish();
    began_ = Clock::now();
}

void PassStopwatch::lap(std::string_view pass) {
    glFinish();
    const Clock::time_point now = Clock::now();
    auto found = std::ranges::find(laps_, pass, &Lap::pass);
    if (found == laps_.end()) {
        found = laps_.insert(laps_.end(), {pass, 0.0});
    }
    found->milliseconds += std::chrono::duration<double, std::milli>(now - began_).count();
    began_ = now;
}

} // namespace patina
