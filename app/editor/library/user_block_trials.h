// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QObject>
#include <QStringList>

#include "background/worker.h"
#include "catalog/catalog.h"
#include "core/error.h"

namespace patina {

/// Has the user's blocks tried in the background (see BlockGate), so that a mistake is told when it
/// is made and not first when the block is chosen.
class UserBlockTrials : public QObject {
    Q_OBJECT

  public:
    explicit UserBlockTrials(QObject* parent = nullptr);

    /// Ends the trial that it waits for.
    ~UserBlockTrials() override;

    /// finished() follows, unless another run is wished meanwhile.
    void run(std::shared_ptr<const Catalog> catalog);

  Q_SIGNALS:
    /// All mistakes in the user's shaders, at their files' own lines.
    void finished(const patina::Errors& mistakes);

  private:
    class Wanted;

    Errors mistakesIn(const Catalog& catalog, const Worker::Control& control);

    Worker worker_;
};

} // namespace patina
