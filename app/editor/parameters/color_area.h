// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QWidget>

namespace patina {

/// Lets a point be dragged in a field; x and y run from 0 to 1, y upwards. The picker's two fields
/// derive from it and differ only in how they paint.
class ColorArea : public QWidget {
    Q_OBJECT

  public:
    explicit ColorArea(QWidget* parent = nullptr);

    void setPoint(const QPointF& point);
    QPointF point() const { return point_; }

  Q_SIGNALS:
    void dragBegan();
    void moved(const QPointF& point);
    void dragEnded();

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QPointF pointAt(const QPointF& pixel) const;
    void nudge(double x, double y);

    QPointF point_{0.0, 0.0};
    QPointF startPoint_;
    bool isDragging_ = false;
};

} // namespace patina
