// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/object_gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QPainter>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "document/scene_edits.h"
#include "scene/scene_limits.h"
#include "scene/turntable.h"
#include "text/counted.h"

namespace patina {
namespace {

constexpr double handlePixels = 80.0; ///< pixels from the middle to the end of an axis
constexpr double middlePixels = 9.0;  ///< pixels; half the size of the handle in the middle
constexpr double gizmoReach = 7.0;    ///< pixels; the pointer has to be this near to a handle
constexpr int middleHandle = 3;       ///< is the handle of all axes; 0 to 2 are those of one axis

constexpr double gizmoMoveStep = 0.1;  ///< metres
constexpr double gizmoTurnStep = 15.0; ///< degrees
constexpr double gizmoScaleStep = 0.1;
constexpr double scalePerPixel = 0.01;
constexpr double edgeOn = 0.15; ///< cosine below which a ring is seen from its side

const std::array<glm::dvec3, 3> worldAxes{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0),
                                          glm::dvec3(0, 0, 1)};
const std::array<QColor, 3> axisColors{QColor(235, 90, 80), QColor(120, 200, 80),
                                       QColor(90, 140, 245)};
const QColor hotAxisColor(255, 220, 90);
const QColor middleColor(230, 230, 230);

double inSteps(double value, double step, bool isStepped) {
    return isStepped ? std::round(value / step) * step : value;
}

std::size_t slot(int axis) {
    return static_cast<std::size_t>(axis);
}

/// Draws the letter of an axis, which tells it from others also without colours.
void drawName(QPainter& painter, int axis, QPointF place, const QColor& color) {
    const QString name(QLatin1Char("xyz"[axis]));
    painter.setPen(QColor(0, 0, 0, 200));
    painter.drawText(place + QPointF(1.0, 1.0), name);
    painter.setPen(color);
    painter.drawText(place, name);
}

} // namespace

ObjectGizmo::ObjectGizmo(Document& document, const HandleModes& modes)
    : document_(document), modes_(modes) {}

bool ObjectGizmo::isShown() const {
    return modes_.gizmo() != Gizmo::None && document_.selection().object() >= 0;
}

ObjectGizmo::Frame ObjectGizmo::frame(const ViewGeometry& view) const {
    const std::vector<Object>& objects = document_.scene().objects;
    const std::vector<int> edited = document_.selection().editedObjects();
    Frame frame{glm::dvec3(0.0), worldAxes, 1.0};
    for (const int index : edited) {
        frame.origin += objects[slot(index)].translation / double(edited.size());
    }
    if (modes_.gizmo() == Gizmo::Scale) { // along the object's own axes
        Object unscaled = objects[slot(document_.selection().object())];
        unscaled.scale = glm::dvec3(1.0);
        const glm::dmat4 world = worldMatrix(unscaled);
        for (int axis = 0; axis < 3; ++axis) {
            frame.axes[slot(axis)] = glm::normalize(glm::dvec3(world[axis]));
        }
    }
    frame.length = handlePixels * view.metresPerPixel(frame.origin);
    return frame;
}

/// Returns what is drawn of an axis: its ring, or the line to its end.
std::vector<QPointF> ObjectGizmo::line(const ViewGeometry& view, const Frame& frame,
                                       int axis) const {
    const glm::dvec3& along = frame.axes[slot(axis)];
    if (modes_.gizmo() == Gizmo::Turn) {
        return view.places(circle(frame.origin, along, frame.length));
    }
    return view.places(std::array{frame.origin, frame.origin + along * frame.length});
}

std::optional<int> ObjectGizmo::handleAt(const ViewGeometry& view, QPointF place) const {
    const Frame now = frame(view);
    const auto origin = view.place(now.origin);
    if (!origin) {
        return std::nullopt;
    }
    const QPointF off = place - *origin;
    if (modes_.gizmo() != Gizmo::Turn &&
        std::max(std::abs(off.x()), std::abs(off.y())) <= middlePixels) {
        return middleHandle;
    }
    std::optional<int> found;
    double nearest = gizmoReach;
    for (int axis = 0; axis < 3; ++axis) {
        if (const double away = distanceToLine(place, line(view, now, axis)); away < nearest) {
            nearest = away;
            found = axis;
        }
    }
    return found;
}

void ObjectGizmo::draw(const ViewGeometry& view, QPainter& painter, std::optional<int> hot) const {
    const Frame now = frame(view);
    const auto origin = view.place(now.origin);
    if (!origin) {
        return;
    }
    const Gizmo mode = modes_.gizmo();
    for (int axis = 0; axis < 3; ++axis) {
        const QColor color = hot == axis ? hotAxisColor : axisColors[slot(axis)];
        const std::vector<QPointF> points = line(view, now, axis);
        painter.setPen(QPen(QColor(0, 0, 0, 120), 5.0));
        painter.drawPolyline(points.data(), static_cast<int>(points.size()));
        painter.setPen(QPen(color, 3.0));
        painter.drawPolyline(points.data(), static_cast<int>(points.size()));
        if (mode == Gizmo::Turn || points.size() < 2) {
            continue;
        }
        painter.setBrush(color);
        painter.setPen(QPen(QColor(0, 0, 0, 120), 2.0));
        const QRectF end(points[1] - QPointF(5.5, 5.5), QSizeF(11.0, 11.0));
        mode == Gizmo::Move ? painter.drawEllipse(end) : painter.drawRect(end);
        painter.setBrush(Qt::NoBrush);
        drawName(painter, axis, points[1] + QPointF(9.0, 5.0), color);
    }
    if (mode != Gizmo::Turn) {
        painter.setPen(QPen(hot == middleHandle ? hotAxisColor : middleColor, 2.0));
        painter.setBrush(QColor(0, 0, 0, 60));
        painter.drawRect(QRectF(*origin - QPointF(middlePixels, middlePixels),
                                QSizeF(2.0 * middlePixels, 2.0 * middlePixels)));
        painter.setBrush(Qt::NoBrush);
    }
}

void ObjectGizmo::begin(const ViewGeometry& view, int handle, QPointF place) {
    handle_ = handle;
    from_ = place;
    start_ = frame(view);
    held_.clear();
    for (const int index : document_.selection().editedObjects()) {
        held_.emplace(index, document_.scene().objects[slot(index)]);
    }
    document_.interaction().begin();
}

void ObjectGizmo::drag(const ViewGeometry& view, QPointF place, bool isStepped) {
    switch (modes_.gizmo()) {
    case Gizmo::Move:
        move(view, place, isStepped);
        break;
    case Gizmo::Turn:
        turn(view, place, isStepped);
        break;
    case Gizmo::Scale:
        scale(view, place, isStepped);
        break;
    case Gizmo::None:
        break;
    }
}

void ObjectGizmo::move(const ViewGeometry& view, QPointF place, bool isStepped) {
    glm::dvec3 by(0.0);
    if (handle_ == middleHandle) {
        by = view.pointBeside(place, start_.origin) - view.pointBeside(from_, start_.origin);
    } else {
        const glm::dvec3& axis = start_.axes[slot(handle_)];
        const double way =
            view.alongAxis(place, start_.origin, axis) - view.alongAxis(from_, start_.origin, axis);
        by = axis * inSteps(way, gizmoMoveStep, isStepped);
    }
    apply([&](Object& object) { object.translation += by; });
}

/// Turns the objects about the middle of all. A ring that is seen from its side turns as far as the
/// pointer moves across its axis.
void ObjectGizmo::turn(const ViewGeometry& view, QPointF place, bool isStepped) {
    const auto origin = view.place(start_.origin);
    if (!origin) {
        return;
    }
    const glm::dvec3& axis = start_.axes[slot(handle_)];
    const glm::dvec3 toEye = glm::normalize(eye(view.camera) - start_.origin);
    const double facing = glm::dot(axis, toEye);
    double degrees = 0.0;
    if (std::abs(facing) < edgeOn) {
        const auto end = view.place(start_.origin + axis * start_.length);
        const QPointF along = end ? *end - *origin : QPointF(1.0, 0.0);
        const QPointF across = QPointF(along.y(), -along.x()) / std::hypot(along.x(), along.y());
        degrees = glm::degrees(QPointF::dotProduct(place - from_, across) / handlePixels);
    } else {
        const auto angle = [&](QPointF p) {
            return std::atan2(origin->y() - p.y(), p.x() - origin->x());
        };
        degrees = std::remainder(glm::degrees(angle(place) - angle(from_)), 360.0);
        degrees *= facing > 0.0 ? 1.0 : -1.0;
    }
    degrees = inSteps(degrees, gizmoTurnStep, isStepped);
    apply([&](Object& object) {
        object.rotation = rotationTurnedAbout(object.rotation, axis, degrees);
        object.translation =
            start_.origin + turnedAbout(object.translation - start_.origin, axis, degrees);
    });
}

void ObjectGizmo::scale(const ViewGeometry& view, QPointF place, bool isStepped) {
    if (handle_ == middleHandle) {
        const double way = (place.x() - from_.x()) - (place.y() - from_.y());
        const double factor = inSteps(std::exp(scalePerPixel * way), gizmoScaleStep, isStepped);
        apply([&](Object& object) { object.scale = usableScale(object.scale * factor); });
        return;
    }
    const glm::dvec3& axis = start_.axes[slot(handle_)];
    const double before = view.alongAxis(from_, start_.origin, axis);
    const double after = view.alongAxis(place, start_.origin, axis);
    const double factor = before != 0.0 ? inSteps(after / before, gizmoScaleStep, isStepped) : 1.0;
    apply([&](Object& object) {
        object.scale[handle_] *= factor;
        object.scale = usableScale(object.scale);
    });
}

/// Returns what the undo step of a drag is called.
QString ObjectGizmo::label() const {
    const std::size_t count = held_.size();
    switch (modes_.gizmo()) {
    case Gizmo::Turn:
        return counted(count, Document::tr("Turn object"), Document::tr("Turn %1 objects"));
    case Gizmo::Scale:
        return counted(count, Document::tr("Scale object"), Document::tr("Scale %1 objects"));
    default:
        return counted(count, Document::tr("Move object"), Document::tr("Move %1 objects"));
    }
}

/// Applies `change` to the objects as they were when the drag began, so that steps do not add up.
void ObjectGizmo::apply(const std::function<void(Object&)>& change) {
    std::map<int, Object> changed = held_;
    for (auto& [index, object] : changed) {
        change(object);
        object.translation = glm::dvec3(glm::vec3(object.translation));
        object.rotation = glm::dvec3(glm::vec3(object.rotation));
        object.scale = glm::dvec3(glm::vec3(object.scale));
    }
    setObjects(document_, changed, label());
}

void ObjectGizmo::end() {
    document_.interaction().end();
}

void ObjectGizmo::cancel() {
    setObjects(document_, held_, label());
    end();
}

} // namespace patina
