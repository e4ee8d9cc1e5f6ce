// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/time/frame_timer.h"

#include <chrono>
#include <string>

#include <epoxy/gl.h>

#include "gl/driver.h"
#include "gpu_fixture.h"
#include "measure/time/timer_work.h"

namespace patina::frame_timer_test {
namespace {

class FrameTimerTest : public GpuTest {};

double wallMilliseconds(const TimerWork& work, int rounds) {
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    work.run(rounds);
    glFinish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

TEST_F(FrameTimerTest, WallClock_SeesAllTheWork) {
    const TimerWork work;
    FrameTimer timer(FrameTimer::Method::WallClock);
    work.run(40);
    timer.begin();
    work.run(40);
    timer.end();
    const double little = timer.milliseconds();
    timer.begin();
    work.run(400);
    timer.end();
    // Ten times the work; a factor of three leaves room for a machine that is busy otherwise.
    EXPECT_GT(timer.milliseconds(), 3.0 * little);
}

TEST_F(FrameTimerTest, ChosenMethod_AgreesWithTheClock) {
    FrameTimer timer;
    const TimerWork work;
    work.run(40);
    timer.begin();
    work.run(400);
    timer.end();
    glFinish();
    timer.begin(); // collects what is ready
    timer.end();
    const double wall = wallMilliseconds(work, 400);
    if (timer.method() == FrameTimer::Method::DeviceTimer) {
        EXPECT_GT(timer.milliseconds(), 0.0);
    }
    RecordProperty("method", std::string(timer.methodText()));
    EXPECT_LT(timer.milliseconds(), 10.0 * wall);
}

TEST_F(FrameTimerTest, SoftwareDriver_IsTimedByTheClock) {
    const std::string name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const bool software = name.find("llvmpipe") != std::string::npos;
    EXPECT_EQ(gl::isSoftware(), software) << name;
    if (software) {
        EXPECT_EQ(trustedMethod(), FrameTimer::Method::WallClock);
    }
}

} // namespace
} // namespace patina::frame_timer_test
