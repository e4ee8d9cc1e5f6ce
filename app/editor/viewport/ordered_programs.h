// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "render/renderer.h"

namespace patina {

class ViewedScene;

/// The programs that a view has made elsewhere (see ProgramWorker), of one frame at a time.
class OrderedPrograms : public QObject {
    Q_OBJECT

  public:
    /// It outlives this.
    explicit OrderedPrograms(const ViewedScene& viewed);

    /// Without anybody who makes programs elsewhere nothing can be ordered.
    bool canOrder() const;

    /// Has those of a frame of a scene made; came() follows unless others are ordered meanwhile.
    void order(const Scene& scene, const View& view);

    bool areAwaited() const { return number_ != 0; }
    void forget() { number_ = 0; }

  Q_SIGNALS:
    void came(); ///< all that could be made

  private:
    void take(quint64 number);

    const ViewedScene& viewed_;
    quint64 number_ = 0; ///< of ProgramWorker::ask(); 0: nothing is ordered, or it came
};

} // namespace patina
