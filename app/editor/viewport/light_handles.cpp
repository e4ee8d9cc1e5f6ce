// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/light_handles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPainter>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/turntable.h"
#include "viewport/camera_moves.h"

namespace patina {
namespace {

/// Lists the parts of a light that can be dragged. The number of a handle is light * PartCount +
/// part.
enum Part { PlacePart, TargetPart, DistancePart, ConePart, PartCount };

constexpr double lampReach = 9.0;
/// Is how far from its target the lamp of a light without a position is at least, as a share of the
/// view's shorter side: beside what fills two thirds of it.
constexpr double lampDistance = 0.44;
/// Is how far inside the view the lamp of a light beside it is shown, in pixels.
constexpr double edgeInset = 22.0;
constexpr double iconPixels = 8.0;
constexpr double dotPixels = 4.5;
constexpr double lampDegreesPerPixel = 0.4;
constexpr double angleStep = 5.0; ///< degrees
/// Says where the handle of the distance may be, as shares of the line from the light to its
/// target: the first that is in the view.
constexpr double distanceShares[] = {0.45, 0.6, 0.75, 0.88};
constexpr double coneAhead = 0.1; ///< is how much farther along that line the ring of the cone is
constexpr double nearestTarget = 0.05; ///< metres
const QColor hotLampColor(255, 220, 90);
const QColor casingColor(0, 0, 0, 120);

int lightOfHandle(int handle) {
    return handle / PartCount;
}

int partOfHandle(int handle) {
    return handle % PartCount;
}

QColor lampColorOf(const Values& values, const Block& block) {
    const auto found = std::ranges::find_if(
        block.parameters, [](const Parameter& each) { return infoOf(each.type).isColor; });
    if (found == block.parameters.end()) {
        return Qt::white;
    }
    const auto held = values.find(found->id);
    const Value& value = held == values.end() ? found->defaultValue : held->second;
    const auto* color = std::get_if<glm::dvec3>(&value);
    const glm::dvec3 c = color ? *color : glm::dvec3(1.0);
    const double brightest = std::max({c.x, c.y, c.z, 1e-6});
    const auto part = [brightest](double x) {
        return float(std::sqrt(std::clamp(x / brightest, 0.0, 1.0)));
    };
    return QColor::fromRgbF(part(c.x), part(c.y), part(c.z));
}

void drawDot(QPainter& painter, QPointF at, double radius, const QColor& color) {
    painter.setPen(QPen(QColor(0, 0, 0, 160), 1.5));
    painter.setBrush(color);
    painter.drawEllipse(at, radius, radius);
    painter.setBrush(Qt::NoBrush);
}

/// Returns what the undo of a drag is called.
QString labelOf(int part, bool hasPoint) {
    switch (part) {
    case TargetPart:
        return Document::tr("Aim light");
    case DistancePart:
        return Document::tr("Change distance of light");
    case ConePart:
        return Document::tr("Change cone of light");
    default:
        return hasPoint ? Document::tr("Move light") : Document::tr("Turn light");
    }
}

QRectF insideOf(const ViewGeometry& view) {
    return {edgeInset, edgeInset, view.size.x - 2.0 * edgeInset, view.size.y - 2.0 * edgeInset};
}

/// Returns the place where the way from a place in the view to one beside it leaves the view;
/// `to` itself where that is in the view, or where neither is.
QPointF keptInView(const ViewGeometry& view, QPointF from, QPointF to) {
    const QRectF inside = insideOf(view);
    if (inside.contains(to) || !inside.contains(from)) {
        return to;
    }
    const QPointF way = to - from;
    double share = 1.0;
    const auto limit = [&share](double start, double by, double low, double high) {
        if (by != 0.0) {
            share = std::min(share, ((by > 0.0 ? high : low) - start) / by);
        }
    };
    limit(from.x(), way.x(), inside.left(), inside.right());
    limit(from.y(), way.y(), inside.top(), inside.bottom());
    return from + way * share;
}

/// Draws a disc with rays for a light, or a grey disc without rays where it is off.
void drawLamp(QPainter& painter, QPointF at, const QColor& color, bool isOn, bool isCurrent) {
    painter.setPen(QPen(QColor(0, 0, 0, 140), 3.5));
    for (int pass = 0; pass < 2; ++pass) {
        for (int ray = 0; ray < 8 && isOn; ++ray) {
            const double angle = glm::radians(45.0 * ray);
            const QPointF way(std::cos(angle), std::sin(angle));
            painter.drawLine(at + way * (iconPixels + 1.0), at + way * (iconPixels + 5.0));
        }
        painter.setPen(QPen(color, 1.8));
    }
    drawDot(painter, at, iconPixels - 2.0, isOn ? color : QColor(60, 60, 60, 150));
    if (isCurrent) {
        painter.setPen(QPen(hotLampColor, 2.0));
        painter.drawEllipse(at, iconPixels + 7.0, iconPixels + 7.0);
    }
}

} // namespace

LightHandles::LightHandles(Document& document, const HandleModes& modes, SurfaceAt surfaceAt)
    : document_(document), modes_(modes), surfaceAt_(std::move(surfaceAt)) {}

bool LightHandles::isShown() const {
    return modes_.showsLights() && !document_.scene().lights.empty();
}

std::optional<LightHandles::Shown> LightHandles::shown(const ViewGeometry& view, int index) const {
    const Light& light = document_.scene().lights[static_cast<std::size_t>(index)];
    const Block* block = document_.catalog().find(kinds::lights, light.block.id);
    const auto place =
        block ? lightPose(light.block.parameters, *block, view.camera) : std::nullopt;
    if (!place) {
        return std::nullopt;
    }
    Shown shown{*place, targetOf(view, *place), light.enabled,
                lampColorOf(light.block.parameters, *block)};
    shown.distanceShare = distanceShareOf(view, index, shown);
    return shown;
}

/// Stays as it was while the light is dragged, so that its handle does not leave the pointer.
double LightHandles::distanceShareOf(const ViewGeometry& view, int index,
                                     const Shown& light) const {
    if (isDragging_ && index == light_) {
        return start_.distanceShare;
    }
    const QRectF inside = insideOf(view);
    const auto* const seen = std::ranges::find_if(distanceShares, [&](double share) {
        const auto place = view.place(glm::mix(light.place.point, light.target, share));
        return place && inside.contains(*place);
    });
    return seen == std::end(distanceShares) ? distanceShares[0] : *seen;
}

/// Returns where its axis meets a surface, or else a point on the axis as far away as the pivot;
/// the pivot itself where the light shines everywhere or has no position.
glm::dvec3 LightHandles::targetOf(const ViewGeometry& view, const LightPose& place) const {
    const glm::dvec3& pivot = view.camera.pivot;
    if (!place.hasPoint() || !place.direction) {
        return pivot;
    }
    if (const auto hit = surfaceAt_({place.point, *place.direction})) {
        return hit->point;
    }
    const double ahead = glm::dot(pivot - place.point, *place.direction);
    return place.point +
           *place.direction *
               (ahead > nearestTarget ? ahead : glm::distance(pivot, place.point) + nearestTarget);
}

/// Returns where the handle of a part is; nothing where the light has no such part.
std::optional<glm::dvec3> LightHandles::pointOf(const Shown& light, int part) const {
    const LightPose& place = light.place;
    switch (part) {
    case PlacePart:
        return place.point;
    case TargetPart:
        return place.hasPoint() && place.direction ? std::optional(light.target) : std::nullopt;
    case DistancePart:
        return place.hasPoint()
                   ? std::optional(glm::mix(place.point, light.target, light.distanceShare))
                   : std::nullopt;
    case ConePart: {
        if (!place.angleOf || !place.hasPoint()) {
            return std::nullopt;
        }
        const glm::dvec3& axis = *place.direction;
        const double angle = glm::radians(std::min(place.angle, 89.0));
        const double away =
            glm::distance(place.point, light.target) * (light.distanceShare + coneAhead);
        return circle(place.point + axis * (away * std::cos(angle)), axis, away * std::sin(angle))
            .front();
    }
    default:
        return std::nullopt;
    }
}

/// Returns where the handle of a part is seen. A lamp beside the view is seen at its edge. That of
/// a light without a position says nothing but a direction, so it stands beside what it shines on
/// rather than before that.
std::optional<QPointF> LightHandles::placeOf(const ViewGeometry& view, const Shown& light,
                                             int part) const {
    const auto point = pointOf(light, part);
    const auto place = point ? view.place(*point) : std::nullopt;
    const auto target = view.place(light.target);
    if (part != PlacePart || !place || !target) {
        return place;
    }
    if (light.place.hasPoint()) {
        return keptInView(view, *target, *place);
    }
    const double minLength = lampDistance * std::min(view.size.x, view.size.y);
    const QPointF way = *place - *target;
    const double length = std::hypot(way.x(), way.y());
    if (length >= minLength) {
        return place;
    }
    // Along the line of sight it has no direction in the view.
    return *target + (length < 1.0 ? QPointF(0.0, -minLength) : way * (minLength / length));
}

std::optional<int> LightHandles::handleAt(const ViewGeometry& view, QPointF at) const {
    std::optional<int> found;
    double nearest = lampReach;
    const auto lights = static_cast<int>(document_.scene().lights.size());
    for (int index = 0; index < lights; ++index) {
        const auto light = shown(view, index);
        const int parts = index == document_.selection().light() ? int(PartCount) : 1;
        for (int part = 0; light && part < parts; ++part) {
            const auto place = placeOf(view, *light, part);
            const double away =
                place ? std::hypot(place->x() - at.x(), place->y() - at.y()) : lampReach;
            if (away < nearest) {
                nearest = away;
                found = index * PartCount + part;
            }
        }
    }
    return found;
}

void LightHandles::draw(const ViewGeometry& view, QPainter& painter, std::optional<int> hot) const {
    for (int i = 0; i < static_cast<int>(document_.scene().lights.size()); ++i) {
        drawLight(view, painter, i, hot);
    }
}

void LightHandles::drawLight(const ViewGeometry& view, QPainter& painter, int index,
                             std::optional<int> hot) const {
    const auto light = shown(view, index);
    const auto at = light ? placeOf(view, *light, PlacePart) : std::nullopt;
    if (!at) {
        return;
    }
    const bool isCurrent = index == document_.selection().light();
    const auto end = view.place(light->target);
    if (isCurrent && end) {
        const QPen casing(casingColor, 3.2); // a white line is seen on white too
        for (const QPen& pen : {casing, QPen(light->color, 1.4, Qt::DashLine)}) {
            painter.setPen(pen);
            painter.drawLine(*at, *end);
            drawCone(view, painter, *light);
        }
    }
    for (int part = TargetPart; isCurrent && part < PartCount; ++part) {
        const auto point = pointOf(*light, part);
        if (const auto place = point ? view.place(*point) : std::nullopt) {
            const bool isHot = hot == index * PartCount + part;
            drawDot(painter, *place, dotPixels, isHot ? hotLampColor : light->color);
        }
    }
    const bool isHot = hot == index * PartCount + PlacePart;
    drawLamp(painter, *at, isHot ? hotLampColor : light->color, light->isOn, isCurrent);
}

void LightHandles::drawCone(const ViewGeometry& view, QPainter& painter, const Shown& light) const {
    const LightPose& place = light.place;
    const auto edge = pointOf(light, ConePart);
    const auto at = view.place(place.point);
    if (!edge || !at) {
        return;
    }
    const glm::dvec3& axis = *place.direction;
    const double along = glm::dot(*edge - place.point, axis);
    const glm::dvec3 middle = place.point + axis * along;
    const std::vector<QPointF> ring =
        view.places(circle(middle, axis, glm::distance(*edge, middle)));
    painter.drawPolyline(ring.data(), static_cast<int>(ring.size()));
    for (std::size_t i = 0; i < ring.size(); i += 12) {
        painter.drawLine(*at, ring[i]);
    }
}

void LightHandles::begin(const ViewGeometry& view, int handle, QPointF place) {
    light_ = lightOfHandle(handle);
    part_ = partOfHandle(handle);
    from_ = place;
    document_.selection().setLight(light_);
    start_ = *shown(view, light_);
    lampAt_ = placeOf(view, start_, PlacePart).value_or(place);
    isDragging_ = true;
    const BlockPath path = pathOf(kinds::lights, light_);
    held_.clear();
    for (const Parameter* part :
         {start_.place.pointOf, start_.place.directionOf, start_.place.angleOf}) {
        if (part) {
            held_.emplace(part->id, document_.value(path, *part));
        }
    }
    document_.interaction().begin();
}

void LightHandles::drag(const ViewGeometry& view, QPointF place, bool isStepped) {
    LightPose moved = start_.place;
    if (part_ == PlacePart && moved.hasPoint()) {
        moved.point = view.pointBeside(lampAt_ + (place - from_), moved.point);
    } else if (part_ == PlacePart) {
        const QPointF turn = (place - from_) * lampDegreesPerPixel;
        const glm::dvec3 tilted = turnedAbout(*moved.direction, rightOf(view.camera), turn.y());
        moved.direction = turnedAbout(tilted, {0.0, 1.0, 0.0}, turn.x());
    } else if (part_ == TargetPart) {
        const auto hit = surfaceAt_(view.ray(place));
        const glm::dvec3 target = hit ? hit->point : view.pointBeside(place, start_.target);
        if (const double away = glm::distance(target, moved.point); away > nearestTarget) {
            moved.direction = (target - moved.point) / away;
        }
    } else if (part_ == DistancePart) {
        const glm::dvec3 way = start_.place.point - start_.target;
        const double length = std::max(glm::length(way), nearestTarget);
        const glm::dvec3 axis = way / length;
        // The handle moves by a share of what the light moves by.
        const double by = (view.alongAxis(place, start_.target, axis) -
                           view.alongAxis(from_, start_.target, axis)) /
                          (1.0 - start_.distanceShare);
        moved.point = start_.target + axis * std::max(length + by, nearestTarget);
    } else {
        const glm::dvec3 edge = view.pointBeside(place, *pointOf(start_, ConePart));
        const glm::dvec3 way = edge - moved.point;
        const double cosine = glm::dot(way, *moved.direction) / std::max(glm::length(way), 1e-12);
        moved.angle = glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
        moved.angle = isStepped ? std::round(moved.angle / angleStep) * angleStep : moved.angle;
    }
    Values values = valuesAt(moved, view.camera);
    if (moved.angleOf) {
        values.emplace(moved.angleOf->id, moved.angle);
    }
    if (moved.directionOf && moved.direction == start_.place.direction) {
        values[moved.directionOf->id] = held_.at(moved.directionOf->id); // keeps its length
    }
    store(values);
}

void LightHandles::store(const Values& values) {
    document_.setValues(pathOf(kinds::lights, light_), values,
                        labelOf(part_, start_.place.hasPoint()));
}

void LightHandles::end() {
    isDragging_ = false;
    document_.interaction().end();
}

void LightHandles::cancel() {
    store(held_);
    end();
}

} // namespace patina
