// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>

#include <QObject>
#include <QStringList>
#include <QThreadPool>

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
    /// These were never tried before; until finished() nothing is drawn with them.
    void begun(const QStringList& names);

    /// All mistakes in the user's shaders, at their files' own lines.
    void finished(const patina::Errors& mistakes);

  private:
    class Wanted;

    Errors mistakesIn(const Catalog& catalog, quint64 number);
    void tellBegun(const QStringList& names, quint64 number);

    std::atomic<quint64> wished_ = 0; ///< the number of the last run
    QThreadPool thread_;
};

} // namespace patina
