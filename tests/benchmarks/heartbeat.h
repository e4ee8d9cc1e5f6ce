// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTimer>

namespace patina::benchmarks {

/// A timer that should fire every few milliseconds, and the longest it was kept waiting: that long
/// the window answered nothing.
class Heartbeat {
  public:
    Heartbeat();

    /// Forgets what was before.
    void start();

    /// Milliseconds between two beats, the one that is still missing included.
    double longestGap() const;

  private:
    void beat();
    double sinceLast() const { return 1e-6 * double(last_.nsecsElapsed()); }

    QElapsedTimer last_;
    QTimer timer_;
    double longest_ = 0.0;
};

} // namespace patina::benchmarks
