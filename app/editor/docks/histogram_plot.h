// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QWidget>

#include "core/picture_histogram.h"

namespace patina {

/// Shows a histogram: luminance as an area, red, green and blue as lines over it, and what is
/// clipped as a bar at its end. Heights are the roots of shares, so that small ones are seen beside
/// an even background.
class HistogramPlot : public QWidget {
    Q_OBJECT

  public:
    enum class Scale { Levels, Stops };

    explicit HistogramPlot(QWidget* parent = nullptr);

    /// Nothing: the plot is empty.
    void setHistogram(Scale scale, std::optional<PictureHistogram> histogram);

    const std::optional<PictureHistogram>& histogram() const { return histogram_; }

    /// Says in words what a place of the plot has, in the widget's pixels; empty outside of it.
    QString textAt(const QPoint& place) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    QRectF area() const;
    double place(double bin) const;
    void paintGrid(QPainter& painter) const;
    void paintClipping(QPainter& painter) const;
    QPolygonF outline(PictureHistogram::Channel channel) const;
    void findHighest();

    Scale scale_ = Scale::Levels;
    std::optional<PictureHistogram> histogram_;
    double highest_ = 1.0; ///< is the share that reaches the top
};

} // namespace patina
