// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>

#include <QObject>
#include <QThreadPool>

#include "catalog/catalog.h"
#include "check/stability_outcome.h"
#include "material/material.h"

namespace patina {

/// Evaluates a material wherever formulas break, on the graphics device and in double precision,
/// in a worker thread with a context of its own.
class StabilityCheck : public QObject {
    Q_OBJECT

  public:
    explicit StabilityCheck(QObject* parent = nullptr);
    ~StabilityCheck() override;

    /// About how many cases a check evaluates.
    static constexpr std::size_t cases = 300000;

    /// Nothing happens while one is running.
    void start(std::shared_ptr<const Catalog> catalog, const Material& material);
    void cancel();
    bool isRunning() const { return running_; }

  Q_SIGNALS:
    void progressed(double share, qulonglong cases); ///< 0 .. 1
    void finished(const patina::StabilityOutcome& outcome); ///< also after cancel()

  private:
    StabilityOutcome check(const Catalog& catalog, const Material& material);

    std::atomic<bool> cancelled_{false};
    bool running_ = false;
    QThreadPool worker_;
};

} // namespace patina
