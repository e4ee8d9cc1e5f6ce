// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/viewport.h"

#include <utility>

#include <QApplication>
#include <QDragEnterEvent>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QPlainTextEdit>
#include <QResizeEvent>

#include "parameters/dropped_files.h"

namespace patina {
namespace {

/// Returns whether letters that are typed into a widget are text.
bool takesText(const QObject* widget) {
    return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QPlainTextEdit*>(widget) ||
           qobject_cast<const QKeySequenceEdit*>(widget);
}

} // namespace

Viewport::Viewport(ViewedScene::Sources sources, QWidget* parent)
    : QWidget(parent), viewed_(std::move(sources), *this), frames_(*this, viewed_),
      prewarmer_(frames_, viewed_), prober_(frames_, *this), capture_(frames_, viewed_) {
    setFocusPolicy(Qt::StrongFocus);
    setAcceptDrops(true);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    setAttribute(Qt::WA_OpaquePaintEvent);
    connect(&frames_.surface(), &ViewSurface::shown, this, &Viewport::shown);
}

Viewport::~Viewport() {
    frames_.close();
}

void Viewport::setCamera(const Camera& camera) {
    if (!(camera == viewed_.camera())) {
        viewed_.setCamera(camera);
        frames_.refresh();
        Q_EMIT cameraChanged();
    }
}

void Viewport::setCatalog(std::shared_ptr<const Catalog> catalog) {
    viewed_.setCatalog(std::move(catalog));
    frames_.announceCatalog();
}

void Viewport::setInspected(std::optional<Inspected> shown) {
    frames_.setInspected(shown);
}

QImage Viewport::grabPicture() {
    frames_.paint();
    return frames_.surface().picture();
}

/// Paints what is seen before the first picture.
void Viewport::paintEvent(QPaintEvent* event) {
    QPainter(this).fillRect(event->rect(), palette().dark());
}

void Viewport::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    frames_.announceSize();
    Q_EMIT resized();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    Q_EMIT activated();
    navigation_.press(*event);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    navigation_.move(*event);
    prober_.setPointer(event->position().toPoint());
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    navigation_.release(*event);
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    navigation_.doubleClick(*event);
}

void Viewport::wheelEvent(QWheelEvent* event) {
    navigation_.wheel(*event);
    event->accept();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    if (!navigation_.keyPress(*event)) {
        QWidget::keyPressEvent(event);
    }
}

void Viewport::keyReleaseEvent(QKeyEvent* event) {
    if (!navigation_.keyRelease(*event)) {
        QWidget::keyReleaseEvent(event);
    }
}

void Viewport::focusInEvent(QFocusEvent* event) {
    Q_EMIT focusShown(event->reason() == Qt::TabFocusReason ||
                      event->reason() == Qt::BacktabFocusReason);
    QWidget::focusInEvent(event);
}

void Viewport::focusOutEvent(QFocusEvent* event) {
    navigation_.focusLost();
    Q_EMIT focusShown(false);
    QWidget::focusOutEvent(event);
}

/// Lets the L key work wherever the pointer is in the view, also before a click brings the focus
/// here.
void Viewport::enterEvent(QEnterEvent* event) {
    qApp->installEventFilter(this);
    prober_.setPointer(event->position().toPoint());
    QWidget::enterEvent(event);
}

void Viewport::leaveEvent(QEvent* event) {
    qApp->removeEventFilter(this);
    prober_.setPointer(std::nullopt);
    QWidget::leaveEvent(event);
}

bool Viewport::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
    const bool isElsewhere = watched->isWidgetType() && watched != this && !takesText(watched) &&
                             static_cast<QWidget*>(watched)->window() == window();
    if (!isKey || !isElsewhere) {
        return QWidget::eventFilter(watched, event);
    }
    const auto& key = *static_cast<QKeyEvent*>(event);
    if (key.key() != Qt::Key_L || key.modifiers() != Qt::NoModifier) {
        return QWidget::eventFilter(watched, event);
    }
    return event->type() == QEvent::KeyPress ? navigation_.keyPress(key)
                                             : navigation_.keyRelease(key);
}

void Viewport::dragEnterEvent(QDragEnterEvent* event) {
    acceptFiles(*event);
}

void Viewport::dropEvent(QDropEvent* event) {
    const QStringList files = draggedFiles(*event->mimeData());
    if (!files.isEmpty()) {
        acceptCopy(*event);
        Q_EMIT filesDropped(files, event->position());
    }
}

} // namespace patina
