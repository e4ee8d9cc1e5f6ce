// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QSizeF>

#include "accuracy/plot_widget.h"

class QPainter;

namespace patina {

/// Is a plot that is painted by hand, on the screen and into files. The pointer reads the values
/// below it.
class PaintedPlot : public PlotWidget {
    Q_OBJECT

  public:
    explicit PaintedPlot(QWidget* parent = nullptr);

    /// Returns what the plot reads at a place of this widget, a line per material; empty beside the
    /// plot.
    virtual QString readingAt(const QPointF& place) const = 0;

    /// Return the plot as the bytes of a file.
    QByteArray png() const;
    QByteArray svg() const;

    QSize sizeHint() const override;

  protected:
    /// Paints the plot, without its ground, into a room of that size.
    virtual void paint(QPainter& painter, const QSizeF& size) const = 0;

    /// Returns the size of the plot in a file, in pixels of a screen.
    virtual QSize fileSize() const;

    void draw() override;
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
};

} // namespace patina
