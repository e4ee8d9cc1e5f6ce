// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/pixel_prober.h"

#include <QWidget>

namespace patina {
namespace {

/// Milliseconds; the pointer's pixel is read at most this often
constexpr int probeMs = 30;

} // namespace

PixelProber::PixelProber(FrameLoop& frames, const QWidget& widget)
    : frames_(frames), widget_(widget) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &PixelProber::probe);
    connect(&frames, &FrameLoop::frameDrawn, this, &PixelProber::probeSoon);
}

void PixelProber::setPointer(std::optional<QPoint> pointer) {
    pointer_ = pointer;
    probeSoon();
}

void PixelProber::probeSoon() {
    if (frames_.isInspecting() && !timer_.isActive()) {
        timer_.start(probeMs);
    }
}

void PixelProber::probe() {
    if (!frames_.canDraw() || !frames_.isInspecting()) {
        return;
    }
    std::optional<PixelProbe> numbers;
    if (pointer_ && widget_.rect().contains(*pointer_)) {
        const QPointF pixel = QPointF(*pointer_) * widget_.devicePixelRatioF();
        numbers = frames_.probe({static_cast<int>(pixel.x()), static_cast<int>(pixel.y())});
    }
    Q_EMIT probed(numbers);
}

} // namespace patina
