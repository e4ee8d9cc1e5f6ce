// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/view_handles.h"

#include <algorithm>
#include <utility>

#include <QMouseEvent>
#include <QPainter>

#include "viewport/viewport.h"

namespace patina {

ViewHandles::ViewHandles(Viewport& viewport, std::vector<std::unique_ptr<HandleSet>> sets)
    : QObject(&viewport), viewport_(viewport), sets_(std::move(sets)) {
    viewport.installEventFilter(this);
}

bool ViewHandles::isShown() const {
    return std::ranges::any_of(sets_, [](const auto& set) { return set->isShown(); });
}

void ViewHandles::draw(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    const ViewGeometry view = geometry();
    for (const auto& set : sets_) {
        if (set->isShown()) {
            const bool isHot = hot_ && hot_->set == set.get();
            set->draw(view, painter, isHot ? std::optional(hot_->number) : std::nullopt);
        }
    }
}

ViewGeometry ViewHandles::geometry() const {
    return {viewport_.camera(), {viewport_.width(), viewport_.height()}};
}

std::optional<ViewHandles::Handle> ViewHandles::handleAt(QPointF place) const {
    const ViewGeometry view = geometry();
    for (const auto& set : sets_) {
        const auto found = set->isShown() ? set->handleAt(view, place) : std::nullopt;
        if (found) {
            return Handle{set.get(), *found};
        }
    }
    return std::nullopt;
}

void ViewHandles::setHot(const std::optional<Handle>& handle) {
    if (handle != hot_) {
        hot_ = handle;
        hot_ ? viewport_.setCursor(Qt::PointingHandCursor) : viewport_.unsetCursor();
        Q_EMIT changed();
    }
}

bool ViewHandles::press(const QMouseEvent& event) {
    const bool isPlain = event.button() == Qt::LeftButton &&
                         (event.modifiers() & ~Qt::ControlModifier) == Qt::NoModifier;
    if (isDragged_ || !isPlain || viewport_.navigation().isLightKeyHeld()) {
        return isDragged_;
    }
    setHot(handleAt(event.position()));
    if (!hot_) {
        return false;
    }
    isDragged_ = true;
    isWaiting_ = false;
    Q_EMIT viewport_.activated();
    hot_->set->begin(geometry(), hot_->number, event.position());
    return true;
}

bool ViewHandles::move(const QMouseEvent& event) {
    if (isDragged_) {
        const bool isStepped = event.modifiers().testFlag(Qt::ControlModifier);
        hot_->set->drag(geometry(), event.position(), isStepped);
        Q_EMIT changed();
    } else if (event.buttons() == Qt::NoButton) {
        setHot(handleAt(event.position()));
    }
    return isDragged_ || (isWaiting_ && event.buttons() != Qt::NoButton);
}

bool ViewHandles::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        return press(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
        return move(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
        if (static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton &&
            std::exchange(isWaiting_, false)) {
            return true;
        }
        if (isDragged_ && static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton) {
            isDragged_ = false;
            hot_->set->end();
            return true;
        }
        break;
    case QEvent::KeyPress:
        if (isDragged_ && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
            isDragged_ = false;
            isWaiting_ = true;
            hot_->set->cancel();
            return true;
        }
        break;
    case QEvent::Leave:
        if (!isDragged_) {
            setHot(std::nullopt);
        }
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace patina
