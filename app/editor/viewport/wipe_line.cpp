// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/wipe_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "session/compare_look.h"

namespace patina {
namespace {

/// Is the distance of grip and knob, as a share of the picture's shorter edge.
constexpr double knobShare = 0.3;

double radians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}

} // namespace

WipeLine::WipeLine(const QSizeF& room, double share, double angle)
    : room_(room), across_(std::cos(radians(angle)), std::sin(radians(angle))),
      reach_(0.5 * (std::abs(across_.x()) * room.width() + std::abs(across_.y()) * room.height())),
      offset_((2.0 * share - 1.0) * reach_) {}

QPointF WipeLine::grip() const {
    return middle() + offset_ * across_;
}

QPointF WipeLine::knob() const {
    return grip() + knobShare * std::min(room_.width(), room_.height()) * along();
}

double WipeLine::depthInB(const QPointF& point) const {
    return QPointF::dotProduct(point - middle(), across_) - offset_;
}

QPolygonF WipeLine::partOfB() const {
    const double far = room_.width() + room_.height();
    const QPointF end = far * along();
    const QPointF deep = 2.0 * far * across_;
    const QPolygonF half({grip() - end, grip() + end, grip() + end + deep, grip() - end + deep});
    return half.intersected(QPolygonF(QRectF({0.0, 0.0}, room_)));
}

double WipeLine::shareThrough(const QPointF& point) const {
    const double offset = QPointF::dotProduct(point - middle(), across_);
    return std::clamp(0.5 + 0.5 * offset / std::max(reach_, 1.0), 0.0, 1.0);
}

double WipeLine::angleTowards(const QPointF& pivot, const QPointF& point) {
    const QPointF way = point - pivot; // points upwards at 0 degrees
    return wrappedAngle(std::atan2(way.x(), -way.y()) * 180.0 / std::numbers::pi);
}

} // namespace patina
