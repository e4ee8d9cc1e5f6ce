// SPDX-License-Identifier: GPL-3.0-or-later
// A view that gets another size: what it shows until there is a picture of that size.
#include <algorithm>

#include <QResizeEvent>

#include "render/gpu/stretched_picture.h"
#include "viewport/viewport.h"

namespace patina {

glm::ivec2 Viewport::pixelsOf(const QSize& size) const {
    const QSize pixels = size * devicePixelRatioF();
    return {std::max(pixels.width(), 1), std::max(pixels.height(), 1)};
}

/// Qt gives the widget an empty buffer for each new size and shows that at once.
void Viewport::resizeEvent(QResizeEvent* event) {
    giveUpFrame();
    const bool hasPicture = renderer_ && frameCount_ > 0 && !event->oldSize().isEmpty();
    if (hasPicture) {
        makeCurrent();
        last_ = std::make_unique<StretchedPicture>(pixelsOf(event->oldSize()));
        last_->take(defaultFramebufferObject());
    }
    resizing_ = true;
    QOpenGLWidget::resizeEvent(event); // paints
    resizing_ = false;
    if (hasPicture) {
        makeCurrent();
        last_.reset();
        doneCurrent();
    }
    refresh();
}

/// Qt paints at every step of a change of layout; to draw once after the last step is enough.
void Viewport::showLast() {
    if (last_) {
        last_->show(defaultFramebufferObject(), pixelsOf(size()));
    }
}

} // namespace patina
