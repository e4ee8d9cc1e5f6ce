// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/drawing_note.h"

#include <QLabel>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>

namespace patina {

DrawingNote::DrawingNote(QOpenGLWidget& widget)
    : widget_(widget), label_(new QLabel(QLabel::tr("Drawing the scene …"), &widget)) {
    label_->setContentsMargins(12, 6, 12, 6);
    label_->setAutoFillBackground(true);
    label_->hide();
}

void DrawingNote::show(bool hasPicture) {
    if (!hasPicture) {
        QOpenGLFunctions& gl = *widget_.context()->functions();
        const QColor empty = widget_.palette().color(QPalette::Dark);
        gl.glBindFramebuffer(GL_FRAMEBUFFER, widget_.defaultFramebufferObject());
        gl.glClearColor(empty.redF(), empty.greenF(), empty.blueF(), 1.0f);
        gl.glClear(GL_COLOR_BUFFER_BIT);
    }
    // Qt would not paint a view that a note covers completely.
    label_->adjustSize();
    label_->move(widget_.rect().center() - label_->rect().center());
    label_->show();
}

void DrawingNote::hide() {
    label_->hide();
}

} // namespace patina
