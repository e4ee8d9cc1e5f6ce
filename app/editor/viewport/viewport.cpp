// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/viewport.h"

#include <utility>

#include <QApplication>
#include <QDragEnterEvent>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QPlainTextEdit>
#include <QResizeEvent>

#include "parameters/dropped_files.h"
#include "render/gpu/stretched_picture.h"

namespace patina {
namespace {

/// Returns whether letters that are typed into a widget are text.
bool takesText(const QObject* widget) {
    return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QPlainTextEdit*>(widget) ||
           qobject_cast<const QKeySequenceEdit*>(widget);
}

} // namespace

Viewport::Viewport(ViewedScene::Sources sources, QWidget* parent)
    : QOpenGLWidget(parent), viewed_(std::move(sources), *this), frames_(*this, viewed_),
      prewarmer_(frames_, viewed_), prober_(frames_, *this), capture_(frames_, viewed_) {
    setFormat(surfaceFormat());
    setFocusPolicy(Qt::StrongFocus);
    setAcceptDrops(true);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    setUpdateBehavior(PartialUpdate); // Qt keeps the last picture until there is another one
}

Viewport::~Viewport() {
    frames_.close();
    if (context()) {
        disconnect(context(), nullptr, &frames_, nullptr); // the base class destroys the context
    }
}

QSurfaceFormat Viewport::surfaceFormat() {
    QSurfaceFormat format;
    format.setVersion(4, 1);
    format.setProfile(QSurfaceFormat::CoreProfile);
    // The renderer has buffers of its own; the widget's only takes the finished picture.
    format.setDepthBufferSize(0);
    format.setStencilBufferSize(0);
    return format;
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

void Viewport::initializeGL() {
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, &frames_, &FrameLoop::close);
    frames_.open();
}

/// Qt paints at every step of a change of layout; the frame is drawn once after the last step.
void Viewport::paintGL() {
    if (!resizing_) {
        frames_.paint();
    } else if (last_) {
        last_->showUndistorted(defaultFramebufferObject(), pixelsOf(*this, size()));
    }
}

/// Qt gives the widget an empty buffer for each new size and shows that at once.
void Viewport::resizeEvent(QResizeEvent* event) {
    frames_.giveUp();
    const bool hasPicture =
        frames_.canDraw() && frames_.frameCount() > 0 && !event->oldSize().isEmpty();
    if (hasPicture) {
        makeCurrent();
        last_ = std::make_unique<StretchedPicture>(pixelsOf(*this, event->oldSize()));
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
        QOpenGLWidget::keyPressEvent(event);
    }
}

void Viewport::keyReleaseEvent(QKeyEvent* event) {
    if (!navigation_.keyRelease(*event)) {
        QOpenGLWidget::keyReleaseEvent(event);
    }
}

void Viewport::focusInEvent(QFocusEvent* event) {
    Q_EMIT focusShown(event->reason() == Qt::TabFocusReason ||
                      event->reason() == Qt::BacktabFocusReason);
    QOpenGLWidget::focusInEvent(event);
}

void Viewport::focusOutEvent(QFocusEvent* event) {
    navigation_.focusLost();
    Q_EMIT focusShown(false);
    QOpenGLWidget::focusOutEvent(event);
}

/// Lets the L key work wherever the pointer is in the view, also before a click brings the focus
/// here.
void Viewport::enterEvent(QEnterEvent* event) {
    qApp->installEventFilter(this);
    prober_.setPointer(event->position().toPoint());
    QOpenGLWidget::enterEvent(event);
}

void Viewport::leaveEvent(QEvent* event) {
    qApp->removeEventFilter(this);
    prober_.setPointer(std::nullopt);
    QOpenGLWidget::leaveEvent(event);
}

bool Viewport::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
    const bool isElsewhere = watched->isWidgetType() && watched != this && !takesText(watched) &&
                             static_cast<QWidget*>(watched)->window() == window();
    if (!isKey || !isElsewhere) {
        return QOpenGLWidget::eventFilter(watched, event);
    }
    const auto& key = *static_cast<QKeyEvent*>(event);
    if (key.key() != Qt::Key_L || key.modifiers() != Qt::NoModifier) {
        return QOpenGLWidget::eventFilter(watched, event);
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
