// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/time/frame_timer.h"

#include <epoxy/gl.h>

#include "gl/driver.h"
#include "measure/time/timer_work.h"

namespace patina {
namespace {

struct Times {
    double device = 0.0; ///< milliseconds
    double wall = 0.0;
};

double since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

Times timed(const TimerWork& work, int rounds) {
    gl::TimeQuery query = gl::TimeQuery::create();
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    query.begin();
    work.run(rounds);
    query.end();
    glFinish();
    return {double(query.nanoseconds()) * 1e-6, since(start)};
}

/// Tells whether both times agree. The wall clock includes the submission, so the device's time may
/// be a little shorter, but not longer.
bool agree(const Times& times) {
    return times.device > 0.6 * times.wall && times.device < 1.1 * times.wall;
}

} // namespace

FrameTimer::Method trustedMethod() {
    // A driver that draws on the CPU bins the triangles while the query runs and shades the tiles
    // when it pleases: it passes the trial below on a good day and shows 0 ms for a real frame.
    if (gl::isSoftware()) {
        return FrameTimer::Method::WallClock;
    }
    const TimerWork work;
    int rounds = 1;
    timed(work, rounds); // the first run also prepares the driver
    Times little = timed(work, rounds);
    for (; little.wall < 0.5 && rounds < 4096; little = timed(work, rounds)) {
        rounds *= 2;
    }
    const Times much = timed(work, 4 * rounds);
    const double growth = much.device / (little.device > 0.0 ? little.device : 1e30);
    const bool trusted = agree(little) && agree(much) && growth > 2.5 && growth < 6.0;
    return trusted ? FrameTimer::Method::DeviceTimer : FrameTimer::Method::WallClock;
}

FrameTimer::FrameTimer() : FrameTimer(trustedMethod()) {}

FrameTimer::FrameTimer(Method method) : method_(method) {}

void FrameTimer::begin() {
    if (method_ == Method::WallClock) {
        glFinish();
        start_ = Clock::now();
        return;
    }
    collect();
    Running& running = queries_[next_];
    measuring_ = !running.started; // all are in flight: this frame is not measured
    if (measuring_) {
        running.query.begin();
    }
}

void FrameTimer::end() {
    if (method_ == Method::WallClock) {
        glFinish();
        milliseconds_ = since(start_);
        return;
    }
    if (measuring_) {
        queries_[next_].query.end();
        queries_[next_].started = true;
        next_ = (next_ + 1) % inFlight;
    }
    collect();
}

void FrameTimer::collect() {
    for (std::size_t i = 0; i < inFlight; ++i) {
        Running& oldest = queries_[(next_ + i) % inFlight];
        if (oldest.started && oldest.query.ready()) {
            milliseconds_ = double(oldest.query.nanoseconds()) * 1e-6;
            oldest.started = false;
        }
    }
}

std::string_view FrameTimer::methodText() const {
    return method_ == Method::DeviceTimer ? "GPU timer" : "clock around glFinish";
}

} // namespace patina
