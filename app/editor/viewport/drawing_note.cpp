// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/drawing_note.h"

#include <QEvent>
#include <QLabel>

#include "viewport/view_surface.h"

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

DrawingNote::DrawingNote(QWidget& widget, ViewSurface& surface)
    : label_(new CenteredLabel(QLabel::tr("Drawing the scene …"), widget)) {
    label_->setContentsMargins(12, 6, 12, 6);
    label_->setAutoFillBackground(true);
    label_->hide();
    surface.addToOverlay(*label_);
}

void DrawingNote::show() {
    label_->show();
}

void DrawingNote::hide() {
    label_->hide();
}

} // namespace patina
