// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QPolygonF>
#include <QSizeF>

namespace patina {

/// Describes the line across a picture that separates A from B. Points are in the picture's pixels,
/// from its upper left corner.
class WipeLine {
  public:
    /// `share` is the part of the picture that shows A, measured across the line: 0 .. 1; `angle`
    /// is that of CompareLook::wipeAngle. `room` is the size of the picture in pixels.
    WipeLine(const QSizeF& room, double share, double angle);

    /// Returns the point that the mouse moves the line by: its point nearest to the middle of the
    /// picture.
    QPointF grip() const;
    /// Returns the point that the mouse turns the line by.
    QPointF knob() const;
    /// Returns its direction, a unit vector; B is to the right of somebody who walks along it.
    QPointF along() const { return {across_.y(), -across_.x()}; }

    /// Returns how far a point is on B's side, in pixels; below 0 on A's.
    double depthInB(const QPointF& point) const;
    /// Returns the part of the picture that shows B.
    QPolygonF partOfB() const;

    /// Returns the share of the parallel line through a point, 0 .. 1.
    double shareThrough(const QPointF& point) const;
    /// Returns the angle, in degrees, of the line through the pivot whose knob points at another
    /// point.
    static double angleTowards(const QPointF& pivot, const QPointF& point);

  private:
    QPointF middle() const { return {0.5 * room_.width(), 0.5 * room_.height()}; }

    QSizeF room_;
    QPointF across_; ///< is a unit vector from A to B
    double reach_;   ///< pixels from the middle of the picture to its edge, across the line
    double offset_;  ///< pixels from the middle of the picture to the line, towards B
};

} // namespace patina
