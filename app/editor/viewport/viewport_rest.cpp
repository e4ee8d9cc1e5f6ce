// SPDX-License-Identifier: GPL-3.0-or-later
// What a view gives back while nothing is drawn.
#include <QApplication>

#include "render/frame/frame_job.h"
#include "viewport/viewport.h"
#include "window/free_memory.h"

namespace patina {
namespace {

/// How long the buffers of a frame are kept for the next one.
constexpr int idleMs = 300;

} // namespace

void Viewport::watchForRest() {
    sinceFrame_.start();
    if (!idleTimer_.isActive()) {
        idleTimer_.start(idleMs);
    }
}

/// The picture that is shown is the widget's; what it was made in is a third of the editor's
/// memory. A drag that rests keeps it, so that going on is as quick as before.
void Viewport::releaseWhenIdle() {
    const bool busy = isDrawing() || wantsSamples() || QApplication::mouseButtons() != Qt::NoButton;
    const qint64 left = idleMs - sinceFrame_.elapsed();
    if (busy || left > 0) {
        idleTimer_.start(busy ? idleMs : static_cast<int>(left));
    } else if (renderer_) {
        makeCurrent();
        renderer_->job().releaseTargets();
        doneCurrent();
        returnFreeMemory();
    }
}

} // namespace patina
