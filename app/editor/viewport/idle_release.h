// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace patina {

/// Calls a function once something has not been used for a while.
class IdleRelease : public QObject {
    Q_OBJECT

  public:
    /// `isBusy` tells whether it will soon be used again, however long ago it was used last.
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
