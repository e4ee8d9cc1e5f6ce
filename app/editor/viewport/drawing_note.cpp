// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/drawing_note.h"

#include <QEvent>
#include <QLabel>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>

namespace patina {
namespace {

/// Stays in the middle of its parent, whose size may change while a scene is drawn.
class CenteredLabel : public QLabel {
  public:
    CenteredLabel(const QString& text, QWidget& parent) : QLabel(text, &parent) {
        parent.installEventFilter(this);
    }

    void center() {
        adjustSize();
        move(parentWidget()->rect().center() - rect().center());
    }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Resize && isVisible()) {
            center();
        }
        return QLabel::eventFilter(watched, event);
    }

    void showEvent(QShowEvent* event) override {
        center();
        QLabel::showEvent(event);
    }
};

} // namespace

DrawingNote::DrawingNote(QOpenGLWidget& widget)
    : widget_(widget), label_(new CenteredLabel(QLabel::tr("Drawing the scene …"), widget)) {
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
    label_->show(); // it is small: Qt would not paint a view that a note covers completely
}

void DrawingNote::hide() {
    label_->hide();
}

} // namespace patina
