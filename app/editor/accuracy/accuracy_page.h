// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "accuracy/chart_target.h"
#include "accuracy/measure_page.h"
#include "accuracy/measured_chart.h"

class QLabel;
class QToolButton;

namespace patina {

class BudgetRow;
class CostList;
class CostPlot;
struct ChartHeading;

/// Shows what accuracy costs: every way to compute a material or to draw the picture, in time and
/// error, measured on demand; one of them is taken by a click, or by a budget. Charts are kept in
/// files: who starts Patina again finds that of the document.
class AccuracyPage : public MeasurePage {
    Q_OBJECT

  public:
    AccuracyPage(const DockContext& context, std::unique_ptr<ChartTarget> target,
                 std::shared_ptr<MeasureTurn> turn);

    /// Nothing happens while that is going on here or on another page, or where nothing can be
    /// measured.
    void measure(CostSweep::Options options = {});

    /// Returns what is shown; without points where nothing was measured.
    const CostChart& chart() const { return numbers<MeasuredChart>().chart; }

    /// Gives the target what a point of the chart has, as one undo step.
    void apply(int point);
    /// Shows the exact way in A and a point of the chart in B, as one undo step, and the difference
    /// beside them.
    void compare(int point);

    QSize sizeHint() const override;

  protected:
    void startMeasuring() override { measure(); }
    MeasuredSubject subject() const override { return target_->subject(); }
    void showNumbers(bool stale) override;
    QByteArray bytesFor(const QString& ending) const override;
    QString nothingText() const override;
    QString outOfDateText() const override;
    QString measuredText() const override;

  private:
    void layOut();
    void connectParts();
    void select(int point);
    void showSelected();
    void takeChart(const Camera& camera, const CostChart& chart);
    /// A point of the chart; null where the target has not the chart's choices.
    const CostPoint* pointAt(int point) const;
    std::string subjectName() const;
    ChartHeading heading() const;

    std::unique_ptr<ChartTarget> target_;
    QToolButton* compare_;
    QLabel* notes_;
    CostPlot* plot_;
    CostList* list_;
    BudgetRow* budget_;
};

} // namespace patina
