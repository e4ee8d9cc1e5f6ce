// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/view_surface.h"

#include <algorithm>
#include <utility>

#include <QCoreApplication>
#include <QEvent>
#include <QOpenGLContext>
#include <QPainter>
#include <QWidget>
#include <QWindow>

#include "viewport/viewed_scene.h"

namespace patina {

ViewSurface::ViewSurface(QWidget& widget, ViewContext& context)
    : widget_(widget), context_(context), window_(new QWindow) {
    window_->setSurfaceType(QSurface::OpenGLSurface);
    window_->setFormat(ViewContext::format());
    window_->setFlag(Qt::WindowTransparentForInput);
    window_->installEventFilter(this);
    container_ = QWidget::createWindowContainer(window_, &widget_);
    container_->setAttribute(Qt::WA_TransparentForMouseEvents);
    container_->setFocusPolicy(Qt::NoFocus);
    container_->hide();
    widget_.installEventFilter(this);
}

Result<std::unique_ptr<Renderer>> ViewSurface::open() {
    auto renderer = context_.open();
    renderer_ = renderer ? renderer->get() : nullptr;
    return renderer;
}

void ViewSurface::close(std::unique_ptr<Renderer> renderer) {
    {
        const ViewContext::Current current(context_);
        renderer_ = nullptr;
        picture_.reset();
        overlay_ = {};
        hasPicture_ = false;
    }
    context_.close(std::move(renderer));
}

/// Input that waits comes first, so that a frame shows all of it.
void ViewSurface::requestPaint() {
    if (!std::exchange(isAsked_, true)) {
        QCoreApplication::postEvent(this, new QEvent(QEvent::UpdateRequest), Qt::LowEventPriority);
    }
}

bool ViewSurface::event(QEvent* event) {
    if (event->type() != QEvent::UpdateRequest) {
        return QObject::event(event);
    }
    isAsked_ = false;
    if (widget_.isVisible() && !widget_.window()->isMinimized()) {
        Q_EMIT paintDue();
    }
    return true;
}

bool ViewSurface::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &widget_ && event->type() == QEvent::Show) {
        requestPaint();
    } else if (watched == &widget_ && event->type() == QEvent::Resize) {
        resize();
    } else if (std::ranges::find(children_, watched) != children_.end()) {
        const QEvent::Type type = event->type();
        if (type == QEvent::Show || type == QEvent::Hide || type == QEvent::Move ||
            (type == QEvent::Paint && !isDrawingOverlay_)) {
            noteOverlay();
        }
    } else if (event->type() == QEvent::Expose && window_->isExposed()) {
        isChanged_ = true; // it was not there, or below another window
        requestPaint();
    }
    return QObject::eventFilter(watched, event);
}

unsigned ViewSurface::framebuffer() {
    return framebuffer(size());
}

unsigned ViewSurface::framebuffer(glm::ivec2 size) {
    fit(size);
    return picture_->framebuffer();
}

bool ViewSurface::isOutgrown() const {
    return hasPicture_ && picture_->size() != size();
}

glm::ivec2 ViewSurface::size() const {
    return pixelsOf(widget_, widget_.size());
}

void ViewSurface::notePicture() {
    hasPicture_ = true;
    isChanged_ = true;
}

void ViewSurface::fit(glm::ivec2 size) {
    if (picture_ && picture_->size() == size) {
        return;
    }
    auto fitting = std::make_unique<StretchedPicture>(size);
    if (hasPicture_ && renderer_ != nullptr) {
        renderer_->showUndistorted(*picture_, {fitting->framebuffer(), size});
    }
    picture_ = std::move(fitting);
    isChanged_ = true;
    isOverlayNew_ = true;
}

void ViewSurface::setOverlay(OverlaySource& source) {
    overlaySource_ = &source;
    noteOverlay();
}

void ViewSurface::addToOverlay(QWidget& child) {
    if (std::ranges::find(children_, &child) == children_.end()) {
        children_.push_back(&child);
        child.installEventFilter(this);
    }
}

void ViewSurface::noteOverlay() {
    isOverlayNew_ = true;
    requestPaint();
}

void ViewSurface::show(Renderer& renderer) {
    if (!hasPicture_ || isCovered_ || !(isChanged_ || isOverlayNew_)) {
        return;
    }
    if (container_->isHidden()) {
        container_->show(); // and its window, once that is exposed
    }
    if (!window_->isExposed()) {
        return;
    }
    const ViewContext::Current current(context_, window_);
    fit();
    if (std::exchange(isOverlayNew_, false)) {
        drawOverlay();
    }
    isChanged_ = false;
    renderer.showInWindow(*picture_, overlay_);
    QOpenGLContext::currentContext()->swapBuffers(window_);
    Q_EMIT shown();
}

void ViewSurface::drawOverlay() {
    const bool isSeen = overlaySource_ != nullptr && overlaySource_->isSeen();
    if (!isSeen && std::ranges::none_of(children_, &QWidget::isVisible)) {
        overlayImage_ = QImage();
        overlay_.take({}, nullptr);
        return;
    }
    const glm::ivec2 pixels = pixelsOf(widget_, widget_.size());
    if (overlayImage_.size() != QSize(pixels.x, pixels.y)) {
        overlayImage_ = QImage(pixels.x, pixels.y, QImage::Format_ARGB32_Premultiplied);
        overlayImage_.setDevicePixelRatio(widget_.devicePixelRatioF());
    }
    overlayImage_.fill(Qt::transparent);
    isDrawingOverlay_ = true;
    QPainter painter(&overlayImage_);
    painter.setFont(widget_.font());
    if (isSeen) {
        overlaySource_->draw(painter);
    }
    for (QWidget* child : children_) {
        if (child->isVisible()) {
            child->render(&painter, child->pos(), {}, QWidget::DrawChildren);
        }
    }
    isDrawingOverlay_ = false;
    overlay_.take(pixels, overlayImage_.constBits());
}

void ViewSurface::setCovered(bool isCovered) {
    isCovered_ = isCovered;
    isChanged_ = true;
    if (isCovered) {
        container_->hide();
    }
    requestPaint();
}

void ViewSurface::resize() {
    container_->setGeometry(widget_.rect());
    isOverlayNew_ = true;
    requestPaint();
}

QImage ViewSurface::picture() {
    if (!hasPicture_) {
        return {};
    }
    const ViewContext::Current current(context_);
    fit();
    const glm::ivec2 size = picture_->size();
    QImage read(size.x, size.y, QImage::Format_RGBX8888);
    picture_->read(read.bits());
    read = std::move(read).mirrored().convertToFormat(QImage::Format_RGB32);
    read.setDevicePixelRatio(widget_.devicePixelRatioF());
    return read;
}

} // namespace patina
