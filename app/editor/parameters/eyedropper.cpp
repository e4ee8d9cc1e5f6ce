// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/eyedropper.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPixmap>
#include <QScreen>
#include <QWidget>

#include "core/color.h"
#include "parameters/color_source.h"

namespace patina {

namespace {

std::optional<glm::dvec3> firstColor(const QPixmap& pixels) {
    if (pixels.isNull()) {
        return std::nullopt;
    }
    const QColor shown = pixels.toImage().pixelColor(0, 0);
    return srgbDecoded(glm::dvec3(shown.redF(), shown.greenF(), shown.blueF()));
}

std::optional<glm::dvec3> pixelOf(const Image& image, const QPoint& place) {
    const bool inside = place.x() >= 0 && place.y() >= 0 && place.x() < image.width &&
                        place.y() < image.height && image.channels >= 3;
    if (!inside) {
        return std::nullopt;
    }
    const auto first =
        static_cast<std::size_t>((place.y() * image.width + place.x()) * image.channels);
    return glm::dvec3(image.pixels[first], image.pixels[first + 1], image.pixels[first + 2]);
}

} // namespace

Eyedropper::Eyedropper(QWidget* anchor) : QObject(anchor), anchor_(anchor) {}

void Eyedropper::start() {
    isPicking_ = true;
    stills_.clear();
    hadTracking_ = anchor_->hasMouseTracking();
    anchor_->setMouseTracking(true);
    anchor_->installEventFilter(this);
    anchor_->grabMouse(Qt::CrossCursor);
    anchor_->grabKeyboard();
}

void Eyedropper::finish(bool taken) {
    isPicking_ = false;
    stills_.clear();
    anchor_->releaseMouse();
    anchor_->releaseKeyboard();
    anchor_->removeEventFilter(this);
    anchor_->setMouseTracking(hadTracking_);
    Q_EMIT finished(taken);
}

bool Eyedropper::eventFilter(QObject* watched, QEvent* event) {
    return isPicking_ && handle(*event) ? true : QObject::eventFilter(watched, event);
}

/// Takes every event of the mouse and the keys until picking ends; returns false for other events.
bool Eyedropper::handle(QEvent& event) {
    switch (event.type()) {
    case QEvent::MouseMove:
        if (const auto color =
                colorAt(static_cast<QMouseEvent&>(event).globalPosition().toPoint())) {
            Q_EMIT hovered(*color);
        }
        return true;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::KeyRelease:
    case QEvent::Wheel:
        return true;
    case QEvent::MouseButtonRelease:
        finish(static_cast<QMouseEvent&>(event).button() == Qt::LeftButton);
        return true;
    case QEvent::ShortcutOverride:
        event.accept();
        return true;
    case QEvent::KeyPress: {
        const int key = static_cast<QKeyEvent&>(event).key();
        if (key == Qt::Key_Escape || key == Qt::Key_Return || key == Qt::Key_Enter) {
            finish(key != Qt::Key_Escape);
        }
        return true;
    }
    case QEvent::Hide:
        finish(false); // nothing more would come
        return false;
    default:
        return false;
    }
}

std::optional<glm::dvec3> Eyedropper::colorAt(const QPoint& place) {
    if (QWidget* widget = QApplication::widgetAt(place)) {
        return lightAt(*widget, widget->mapFromGlobal(place));
    }
    QScreen* screen = QGuiApplication::screenAt(place);
    const QPoint corner = screen ? screen->geometry().topLeft() : QPoint();
    return screen ? firstColor(
                        screen->grabWindow(0, place.x() - corner.x(), place.y() - corner.y(), 1, 1))
                  : std::nullopt;
}

std::optional<glm::dvec3> Eyedropper::lightAt(QWidget& widget, const QPoint& place) {
    auto* source = dynamic_cast<ColorSource*>(&widget);
    if (!source) {
        return firstColor(widget.grab(QRect(place, QSize(1, 1))));
    }
    const auto [still, isNew] = stills_.try_emplace(&widget);
    if (isNew) {
        still->second = source->linearPicture();
    }
    return pixelOf(still->second, (QPointF(place) * widget.devicePixelRatioF()).toPoint());
}

} // namespace patina
