// SPDX-License-Identifier: GPL-3.0-or-later
// The editor while a slider is dragged with the mouse, one move after each finished frame and then
// many at once. With GALLIUM_NOOP=1 Mesa's driver draws nothing, so that what is left is our own
// work, Qt's and that of Mesa's front end.
// patina-dragging-editor: prints a line "number limit unit what" per figure.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <vector>

#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QMouseEvent>

#include "catalog/catalog.h"
#include "parameters/value_slider.h"
#include "window/main_window.h"

namespace {

using namespace patina;

constexpr int limitMs = 60000;
constexpr int warming = 30;
constexpr int moves = 1000;
constexpr int burst = 50;
constexpr double maxMedian = 1.0;      ///< ms
constexpr double maxNinetyNinth = 4.0; ///< ms
constexpr double maxWaiting = 1.0;     ///< frames

double threadMilliseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

bool waitFor(const std::function<bool()>& done) {
    QElapsedTimer time;
    time.start();
    while (!done() && time.elapsed() < limitMs) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    return done();
}

/// Drags the first slider of the parameters.
class Drag {
  public:
    Drag(ValueSlider& slider, FrameLoop& frames) : slider_(slider), frames_(frames) {
        send(QEvent::MouseButtonPress, slider.width() / 2);
    }
    ~Drag() { send(QEvent::MouseButtonRelease, slider_.width() / 2); }

    void move() {
        ++step_;
        const int reach = slider_.width() / 3;
        const int place = step_ % (2 * reach);
        send(QEvent::MouseMove, slider_.width() / 3 + (place < reach ? place : 2 * reach - place));
    }

    bool waitForFrame() {
        return waitFor([this] { return frames_.isUpToDate(); });
    }

  private:
    void send(QEvent::Type type, int x) {
        const QPointF place(x, slider_.height() / 2);
        QMouseEvent event(type, place, slider_.mapToGlobal(place),
                          type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
        QApplication::sendEvent(&slider_, &event);
    }

    ValueSlider& slider_;
    FrameLoop& frames_;
    int step_ = 0;
};

bool measure(MainWindow& window) {
    auto* slider = window.dock("parameters")->findChild<ValueSlider*>();
    FrameLoop& frames = window.views().first().viewport().frames();
    if (slider == nullptr || !waitFor([&] { return frames.isUpToDate(); })) {
        return false;
    }
    Drag drag(*slider, frames);
    std::vector<double> own;
    for (int i = 0; i < warming + moves; ++i) {
        const int drawn = frames.frameCount();
        const double before = threadMilliseconds();
        drag.move();
        if (!drag.waitForFrame()) {
            return false;
        }
        if (i >= warming && frames.frameCount() > drawn) {
            own.push_back(threadMilliseconds() - before);
        }
    }
    if (own.size() < moves / 2) {
        return false; // most moves changed nothing
    }
    std::ranges::sort(own);
    std::printf("%.3f %g ms from event to finished frame, median\n", own[own.size() / 2],
                maxMedian);
    std::printf("%.3f %g ms from event to finished frame, 99th percentile\n",
                own[own.size() * 99 / 100], maxNinetyNinth);
    const int drawn = frames.frameCount();
    for (int i = 0; i < burst; ++i) {
        drag.move();
    }
    if (!drag.waitForFrame()) {
        return false;
    }
    std::printf("%d %g frames waiting after %d moves at once\n", frames.frameCount() - drawn,
                maxWaiting, burst);
    return true;
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication::setApplicationName("patina-dragging-editor");
    QApplication application(argc, argv);
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    Theme theme;
    MainWindow window(catalog, theme);
    window.documentFiles().openTemplate(defaultSceneFile());
    window.show();
    FrameLoop& frames = window.views().first().viewport().frames();
    if (!waitFor([&] { return frames.frameCount() > 0 && frames.isUpToDate(); })) {
        std::fprintf(stderr, "no first frame seen (is there a display?)\n");
        return 1;
    }
    QElapsedTimer settling; // of what start-up leaves for later
    settling.start();
    waitFor([&] { return settling.elapsed() > 5000; });
    if (!measure(window)) {
        std::fprintf(stderr, "a frame did not come, or the slider moved nothing\n");
        return 1;
    }
    return 0;
}
