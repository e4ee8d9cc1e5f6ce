// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor_course.h"

#include <cstdio>

#include <QCoreApplication>
#include <QElapsedTimer>

namespace patina::benchmarks {
namespace {

constexpr int limitMs = 300000;
constexpr int restMs = 600;

} // namespace

EditorCourse::EditorCourse(MainWindow& window) : view_(window.views().first().viewport()) {
    QObject::connect(&view_, &Viewport::shown, &window,
                     [this] { onScreen_ = view_.frames().frameCount(); });
}

EditorCourse::Cost EditorCourse::take(const std::string& name, const std::function<void()>& begin,
                                      const std::function<bool()>& done) {
    rest(restMs);
    heart_.start();
    QElapsedTimer time;
    time.start();
    begin();
    if (!waitUntil(done) || !waitForPicture()) {
        std::fprintf(stderr, "%s: not done in time\n", name.c_str());
        return {};
    }
    const double milliseconds = 1e-6 * double(time.nsecsElapsed());
    return {heart_.longestGap(), milliseconds};
}

bool EditorCourse::step(const std::string& name, const std::function<void()>& begin,
                        const std::function<bool()>& done) {
    const Cost cost = take(name, begin, done);
    if (cost.gap < 0.0) {
        return false;
    }
    printStep(cost, name);
    return true;
}

void EditorCourse::rest(int milliseconds) {
    QElapsedTimer time;
    time.start();
    waitUntil([&] { return time.elapsed() >= milliseconds; });
}

bool EditorCourse::waitUntil(const std::function<bool()>& done) {
    QElapsedTimer time;
    time.start();
    while (!done() && time.elapsed() < limitMs) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    return done();
}

/// One more frame than was asked for until now, so that it shows all of it.
bool EditorCourse::waitForPicture() {
    const int drawn = view_.frames().frameCount();
    view_.frames().refresh();
    return waitUntil([&] { return onScreen_ > drawn; });
}

void printStep(const EditorCourse::Cost& cost, const std::string& name) {
    std::printf("%.1f %.1f %s\n", cost.gap, cost.time, name.c_str());
}

} // namespace patina::benchmarks
