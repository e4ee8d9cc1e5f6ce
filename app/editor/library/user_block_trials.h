// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QObject>
#include <QStringList>

#include "background/worker.h"
#include "catalog/catalog.h"
#include "core/error.h"

namespace patina {

/// Tries the user's blocks in the background (see BlockGate), so that a mistake is told when it is
/// made, not when the block is chosen.
class UserBlockTrials : public QObject {
    Q_OBJECT

  public:
    explicit UserBlockTrials(QObject* parent = nullptr);

    /// Cancels the trial that is running.
    ~UserBlockTrials() override;

    /// Tries all of the user's blocks; finished() follows, unless run() is called again before.
    /// Where the trials are cancelled, what was not tried stays out of all programs until then.
    void run(std::shared_ptr<const Catalog> catalog);

  Q_SIGNALS:
    /// Is emitted with all mistakes in the user's shaders, at the lines of their own files.
    void finished(const patina::Errors& mistakes);

  private:
    class Wanted;

    Errors mistakesIn(const Catalog& catalog, const Worker::Control& control);

    Worker worker_;
};

} // namespace patina
