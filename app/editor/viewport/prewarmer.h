// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QObject>
#include <QTimer>

#include "viewport/frame_loop.h"
#include "viewport/ordered_programs.h"

namespace patina {

/// Has the programs made of scenes that a view may soon show, one at a time while it has nothing to
/// draw.
class Prewarmer : public QObject {
    Q_OBJECT

  public:
    /// Both outlive it.
    Prewarmer(FrameLoop& frames, const ViewedScene& viewed);

    /// A frame of this scene may be wanted soon.
    void add(const Scene& ahead);

    /// Something is still to be made.
    bool isBusy() const { return !scenes_.empty(); }

  private:
    void goOn();
    void makeNext();
    void prepare();
    View viewAhead() const;

    FrameLoop& frames_;
    std::vector<Scene> scenes_; ///< whose programs are still to be made
    OrderedPrograms programs_;  ///< of the last of them
    QTimer turn_;               ///< one of them a turn
};

} // namespace patina
