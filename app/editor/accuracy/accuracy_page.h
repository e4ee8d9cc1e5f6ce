// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include <QTimer>
#include <QWidget>

#include "accuracy/chart_store.h"
#include "accuracy/chart_target.h"
#include "accuracy/kept_chart.h"
#include "background/background_job.h"
#include "docks/dock_context.h"
#include "measure/cost/cost_sweep.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace patina {

class BudgetRow;
class CostList;
class CostPlot;
class LongLine;
struct ChartHeading;
class MeasureTurn;

/// What accuracy costs: every way to compute a material or to draw the picture, in time and error,
/// measured on demand; one of them is taken by a click, or by a budget. Charts are kept
/// in files: who starts Patina again finds that of the document.
class AccuracyPage : public QWidget {
    Q_OBJECT

  public:
    AccuracyPage(const DockContext& context, std::unique_ptr<ChartTarget> target,
                 std::shared_ptr<MeasureTurn> turn);

    /// Nothing happens while that is going on here or on another page, or where nothing can be
    /// measured.
    void measure(CostSweep::Options options);
    void measure();
    bool isMeasuring() const { return measurement_.isRunning(); }

    /// What is shown; null where nothing was measured.
    const KeptChart* shown() const { return shown_; }
    /// What is shown is of another material or scene than is on the screen. Another camera is none:
    /// the chart stays that of where it was measured from.
    bool isStale() const { return stale_; }

    /// Gives the target what a point of the chart has, as one undo step.
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
    void showChart(const KeptChart* chart);
    void showState();
    void select(int point);
    BackgroundJob::End sweep(const CostSweep::Subject& subject, const CostSweep::Options& options,
                             BackgroundJob::Control& control);
    void showStep(const SweepStep& step);
    void showRunning(const CostChart& chart);
    void finish(bool complete, const QString& problem);
    const KeptChart* keptFor(const MeasuredSubject& subject);
    const KeptChart* fromBefore(const MeasuredSubject& subject);
    void read(const ChartKey& key);
    void store(const KeptChart& chart);
    ChartKey keyOf(const std::string& file, int object) const;
    const std::string& device();
    QString stateText() const;
    QString staleStateText() const;
    QString measuredText() const;
    std::string file() const; ///< the document's
    /// A point of the chart; null where the target has not the chart's choices.
    const CostPoint* pointAt(int point) const;
    std::string subjectName() const;
    ChartHeading heading() const;
    QByteArray bytesFor(const QString& ending) const;

    Document& document_;
    DocumentFiles& documentFiles_;
    MeshLibrary& library_;
    TextureLibrary& textures_;
    EnvironmentLibrary& environments_;
    MessageLog& messages_;
    std::unique_ptr<ChartTarget> target_;
    std::shared_ptr<MeasureTurn> turn_;
    BackgroundJob measurement_; ///< the last: it ends before what it tells
    KeptResults<KeptChart> charts_;
    ChartStore store_;
    std::set<ChartKey> stored_;              ///< what was read of the store or written to it
    std::optional<std::string> device_;      ///< its name, once it was asked for
    std::map<ChartKey, StoredChart> before_; ///< what was read, while it is of another subject
    std::optional<KeptChart> running_;       ///< what is being measured
    SweepStep step_;                         ///< of that
    const KeptChart* shown_ = nullptr;
    bool stale_ = false;
    std::vector<Choice> choices_; ///< of the target
    QTimer settle_;               ///< changes of the document are gathered
    QToolButton* start_;
    QToolButton* cancel_;
    QToolButton* compare_;
    QToolButton* export_;
    QProgressBar* progress_;
    LongLine* state_;
    QLabel* notes_;
    CostPlot* plot_;
    CostList* list_;
    BudgetRow* budget_;
};

} // namespace patina
