// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "background/worker.h"
#include "docks/dock_context.h"
#include "docks/stability_outcome.h"
#include "library/read_blocks.h"

class QLabel;
class QProgressBar;
class QToolButton;
class QTreeWidget;

namespace patina {

/// Checks the active material in the edge cases of its formulas, and lists what breaks.
class StabilityDock : public QWidget {
    Q_OBJECT

  public:
    explicit StabilityDock(const DockContext& context);

    /// Checks the active side's material; does nothing while a check is running.
    void start();
    bool isRunning() const { return !check_.isIdle(); }

  private:
    void connectParts();
    void showOutcome(const Result<StabilityOutcome>& checked);
    void fill(const StabilityOutcome& outcome);
    void showState();
    void showProgress(double share, const QString& cases);
    bool isStale() const;
    void copyLine() const;

    Document& document_;
    KnownBlocks blocks_; ///< holds the blocks of the checked material
    Material checked_;
    QString verdict_; ///< is that of the last check; empty if there was none
    QToolButton* start_;
    QToolButton* cancel_;
    QToolButton* copy_;
    QProgressBar* progress_;
    QLabel* verdictLabel_;
    QLabel* remarks_;
    QTreeWidget* list_;
    Worker check_;
};

} // namespace patina
