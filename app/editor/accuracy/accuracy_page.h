// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QTimer>
#include <QWidget>

#include "accuracy/kept_charts.h"
#include "check/cost_measurement.h"
#include "docks/dock_context.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace patina {

class BudgetRow;
class CostList;
class CostPlot;

/// What accuracy costs: every way to compute the active material, in time and error, measured on
/// demand; one of them is given to the material by a click, or by a budget.
class AccuracyPage : public QWidget {
    Q_OBJECT

  public:
    explicit AccuracyPage(const DockContext& context);

    /// Nothing happens while that is going on, or where nothing can be measured.
    void measure(CostSweep::Options options);
    void measure();
    bool isMeasuring() const { return measurement_.isRunning(); }

    /// What is shown; null where nothing was measured.
    const KeptChart* shown() const { return shown_; }
    /// What is shown is of another material or scene than is on the screen. Another camera is none:
    /// the chart stays that of where it was measured from.
    bool isStale() const { return stale_; }

    /// Gives the material what a point of the chart has, as one undo step.
    void apply(int point);
    /// Shows the exact way in A and a point of the chart in B, as one undo step, and the difference
    /// in C.
    void compare(int point);
    /// Writes the chart: CSV, PNG, SVG or else JSON, by the file's ending.
    void exportTo(const QString& file);

    QSize sizeHint() const override;

  protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void layOut();
    void connectParts();
    void makeExportMenu();
    void follow();
    void updateChoices();
    void showChart(const KeptChart* chart);
    void showState();
    void select(int point);
    void take(const CostMeasurement::Outcome& outcome);
    QString stateText() const;
    QString measuredText() const;
    ChartSubject subject() const;
    /// The active material with the levels of a point; nothing where they are not its own.
    std::optional<Material> materialOf(int point) const;
    QByteArray bytesFor(const QString& ending) const;

    Document& document_;
    MeshLibrary& library_;
    EnvironmentLibrary& environments_;
    MessageLog& messages_;
    CompareArea& views_;
    CostMeasurement measurement_;
    KeptCharts charts_;
    std::optional<KeptChart> running_; ///< what is being measured
    const KeptChart* shown_ = nullptr;
    bool stale_ = false;
    std::vector<Choice> choices_; ///< of the active material
    QTimer settle_;               ///< changes of the document are gathered
    QToolButton* start_;
    QToolButton* cancel_;
    QToolButton* compare_;
    QToolButton* export_;
    QProgressBar* progress_;
    QLabel* state_;
    CostPlot* plot_;
    CostList* list_;
    BudgetRow* budget_;
};

} // namespace patina
