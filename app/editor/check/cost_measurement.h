// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

#include <QObject>
#include <QString>
#include <QThreadPool>

#include "measure/cost_sweep.h"

namespace patina {

/// Measures what each way to compute a material costs and how wrong it is, in a worker thread with
/// a context of its own.
class CostMeasurement : public QObject {
    Q_OBJECT

  public:
    explicit CostMeasurement(QObject* parent = nullptr);
    ~CostMeasurement() override;

    /// Nothing happens while one is running. The meshes must be there until it has finished.
    void start(CostSweep::Subject subject, CostSweep::Options options);
    void cancel();
    bool isRunning() const { return running_; }

    /// What was measured, and whether all of it.
    struct Outcome {
        CostChart chart;
        bool complete = false;
        QString problem; ///< why it ended before its time; else empty
    };

  Q_SIGNALS:
    void progressed(const patina::SweepStep& step);
    void charted(const patina::CostChart& chart);    ///< there are more points than before
    void finished(const patina::CostMeasurement::Outcome& outcome); ///< also after cancel()

  private:
    Outcome measure(CostSweep::Subject subject, const CostSweep::Options& options);
    void tell(const CostSweep& sweep);

    std::atomic<bool> cancelled_{false};
    bool running_ = false;
    std::size_t told_ = 0; ///< points; of the worker's thread
    QThreadPool worker_;
};

} // namespace patina
