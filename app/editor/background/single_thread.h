// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QThreadPool>

namespace patina {

/// Does one thing after the other beside the editor's own thread.
class SingleThread : public QThreadPool {
  public:
    /// The thread ends when it had nothing to do for so long.
    explicit SingleThread(int idleMs) {
        setMaxThreadCount(1);
        setExpiryTimeout(idleMs);
    }
};

} // namespace patina
