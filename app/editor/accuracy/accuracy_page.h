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

/// Shows time and error of every combination of levels of a material or of the picture, measured on
/// demand. A click or a budget applies one of them. Charts are kept in files, so that the chart of
/// a document is found again after a restart.
class AccuracyPage : public MeasurePage {
    Q_OBJECT

  public:
    AccuracyPage(const DockContext& context, std::unique_ptr<ChartTarget> target,
                 std::shared_ptr<MeasureTurn> turn);

    /// Starts a measurement. Does nothing while this or another page measures, or where nothing can
    /// be measured.
    void measure(CostSweep::Options options = {});

    /// Returns the chart that is shown; it has no points where nothing was measured.
    const CostChart& chart() const { return numbers<MeasuredChart>().chart; }

    /// Returns the chart as it is drawn: the same, or with the times of the chosen graphics card.
    const CostChart& drawnChart() const { return drawn_; }

    /// Gives the target the levels of a point of the chart, as one undo step. Does nothing for a
    /// point that is not in the chart, or when the target's choices have changed since.
    void apply(int point);
    /// Shows the exact levels in A, those of a point of the chart in B and the difference beside
    /// them, as one undo step.
    void compare(int point);

    /// Puts a button into the row above the chart.
    void addButton(QToolButton* button);

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
    /// Puts the times of the chosen graphics card into the drawn chart; returns why it cannot.
    QString predict();
    /// Returns a point of the chart; null if it is not there, or if the chart's choices are not the
    /// target's.
    const CostPoint* pointAt(int point) const;
    std::string subjectName() const;
    ChartHeading heading() const;

    std::unique_ptr<ChartTarget> target_;
    CostChart drawn_;
    QToolButton* compare_;
    QLabel* notes_;
    CostPlot* plot_;
    CostList* list_;
    BudgetRow* budget_;
};

} // namespace patina
