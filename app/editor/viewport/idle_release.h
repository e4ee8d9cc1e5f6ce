// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace patina {

/// Has something given back that was not used for a while.
class IdleRelease : public QObject {
    Q_OBJECT

  public:
    /// `isBusy` says that it will be used again soon, whatever the time.
    IdleRelease(std::function<bool()> isBusy, std::function<void()> release);

    void noteUse();

  private:
    void check();

    std::function<bool()> isBusy_;
    std::function<void()> release_;
    QElapsedTimer sinceUse_;
    QTimer timer_;
};

} // namespace patina
