// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>

#include <QObject>
#include <QString>
#include <QThreadPool>

#include "measure/effect_cost.h"

namespace patina {

/// Measures what the effects of a scene cost, in a worker thread with a context of its own.
class EffectMeasurement : public QObject {
    Q_OBJECT

  public:
    explicit EffectMeasurement(std::filesystem::path programCache, QObject* parent = nullptr);
    ~EffectMeasurement() override;

    /// Nothing happens while one is running. The meshes must be there until it has finished.
    void start(EffectCostMeter::Subject subject);
    void cancel();
    bool isRunning() const { return running_; }

    /// What was measured, and whether all of it.
    struct Outcome {
        EffectCosts costs;
        bool complete = false;
        QString problem; ///< why nothing could be measured; else empty
    };

  Q_SIGNALS:
    void progressed(double share);                                    ///< 0 .. 1
    void finished(const patina::EffectMeasurement::Outcome& outcome); ///< also after cancel()

  private:
    Outcome measure(EffectCostMeter::Subject subject);

    std::filesystem::path programCache_;
    std::atomic<bool> cancelled_{false};
    bool running_ = false;
    QThreadPool worker_;
};

} // namespace patina
