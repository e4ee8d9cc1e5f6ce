// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Viewport that shows the numerical check and reads the pixel under the pointer.
#include <utility>

#include "render/surfaces/inspection_drawer.h"
#include "viewport/viewport.h"

namespace patina {
namespace {

/// The pointer's pixel is read at most this often.
constexpr int probeMs = 30;

} // namespace

void Viewport::setInspecting(bool on) {
    if (on != inspecting_) {
        giveUpFrame();
        inspecting_ = on;
        setMouseTracking(on);
        refresh();
    }
}

void Viewport::probeSoon() {
    if (inspecting_ && !probeTimer_.isActive()) {
        probeTimer_.start(probeMs);
    }
}

void Viewport::probe() {
    if (!renderer_ || !inspecting_) {
        return;
    }
    std::optional<PixelProbe> numbers;
    if (pointer_ && rect().contains(*pointer_)) {
        const QPointF pixel = QPointF(*pointer_) * devicePixelRatioF();
        makeCurrent();
        auto found = renderer_->inspection().probe(
            sources_.scene(), view(), sources_.meshes,
            {static_cast<int>(pixel.x()), static_cast<int>(pixel.y())});
        doneCurrent();
        numbers = found ? std::move(*found) : std::nullopt;
    }
    Q_EMIT probed(numbers);
}

} // namespace patina
