// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "accuracy/chart_export.h"
#include "accuracy/plot_widget.h"

class QCustomPlot;

namespace patina {

/// Draws the points of a chart, time per pixel against error on log axes, with the front as a line
/// and a ring round the current point. A click or Enter picks a point; left and right select the
/// next one in time.
class CostPlot : public PlotWidget {
    Q_OBJECT

  public:
    explicit CostPlot(QWidget* parent = nullptr);
    ~CostPlot() override;

    /// See CostList::setChart().
    void setChart(const CostChart& chart, const ChosenLevels& current, bool stale);

    int selected() const { return selected_; }
    void select(int point);

    /// Returns where a point is drawn, in pixels of this widget.
    QPoint placeOf(int point) const;

    /// Return the chart as the bytes of a file.
    QByteArray png(const ChartHeading& heading = {}) const;
    QByteArray svg(const ChartHeading& heading = {}) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  Q_SIGNALS:
    void picked(int point);
    void selectionMoved(int point); ///< is emitted when the artist moves it, not by select()

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    int currentPoint() const;
    void draw() override;
    void hover(QPoint place, QPoint global);
    void moveSelection(int steps);
    int pointAt(QPoint place) const;
    QString textOf(int point) const;

    CostChart chart_;
    ChosenLevels current_;
    bool stale_ = false;
    int selected_ = -1;
    QCustomPlot* plot_;
    std::unique_ptr<PlotMarks> marks_;
};

} // namespace patina
