// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTimer>

namespace patina::benchmarks {

/// Is a timer that should fire every few milliseconds. It measures the longest time it had to wait,
/// in which the window did not answer.
class Heartbeat {
  public:
    Heartbeat();

    /// Forgets all gaps so far.
    void start();

    /// Returns the longest time between two beats in milliseconds, up to now for the next one.
    double longestGap() const;

  private:
    void beat();
    double sinceLast() const { return 1e-6 * double(last_.nsecsElapsed()); }

    QElapsedTimer last_;
    QTimer timer_;
    double longest_ = 0.0;
};

} // namespace patina::benchmarks
