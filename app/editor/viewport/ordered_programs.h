// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "render/renderer.h"

namespace patina {

class ViewedScene;

/// Has the programs of a frame made by the ProgramWorker of a view, for one frame at a time.
class OrderedPrograms : public QObject {
    Q_OBJECT

  public:
    /// `viewed` outlives this.
    explicit OrderedPrograms(const ViewedScene& viewed);

    /// Tells whether the view has a ProgramWorker; without one nothing can be ordered.
    bool canOrder() const;

    /// Has the programs of a frame of a scene made; came() follows unless others are ordered
    /// meanwhile.
    void order(const Scene& scene, const View& view);

    bool areAwaited() const { return number_ != 0; }
    void forget() { number_ = 0; }

  Q_SIGNALS:
    void came(); ///< is sent when all programs that could be made are there

  private:
    void take(quint64 number);

    const ViewedScene& viewed_;
    quint64 number_ = 0; ///< is what ProgramWorker::ask() returned; 0 while nothing is awaited
};

} // namespace patina
