// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QPolygonF>
#include <QSizeF>

namespace patina {

/// The line across a picture that parts A from B. Points are in the picture's pixels, from its
/// upper left corner.
class WipeLine {
  public:
    /// `share` of the picture has A, measured across the line: 0 .. 1; `angle` as
    /// CompareLook::wipeAngle.
    WipeLine(const QSizeF& room, double share, double angle);

    /// Where it is moved by: the point of it that is nearest to the middle of the picture.
    QPointF grip() const;
    /// Where it is turned by.
    QPointF knob() const;
    /// Its direction; B is to the right of somebody who walks along it.
    QPointF along() const { return {across_.y(), -across_.x()}; }

    /// How far a point is on B's side; below 0 on A's.
    double depthInB(const QPointF& point) const;
    /// The part of the picture that B has.
    QPolygonF partOfB() const;

    /// The share of the parallel line through a point.
    double shareThrough(const QPointF& point) const;
    /// The angle of the line through the pivot whose knob's end points at another point.
    static double angleTowards(const QPointF& pivot, const QPointF& point);

  private:
    QPointF middle() const { return {0.5 * room_.width(), 0.5 * room_.height()}; }

    QSizeF room_;
    QPointF across_; ///< of length 1, from A to B
    double reach_;   ///< of the picture across the line, from its middle
    double offset_;  ///< of the line from the middle
};

} // namespace patina
