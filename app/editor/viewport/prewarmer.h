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
    bool isBusy() const { return !ahead_.empty(); }

  private:
    /// A scene, drawn as while it changes or as at rest.
    struct Ahead {
        Scene scene;
        bool isMoving = false;
    };

    void goOn();
    void makeNext();
    void prepare();
    View viewOf(const Ahead& ahead) const;

    FrameLoop& frames_;
    const ViewedScene& viewed_;
    std::vector<Ahead> ahead_; ///< whose programs are still to be made
    OrderedPrograms programs_; ///< of the last of them
    QTimer turn_;              ///< one of them a turn
};

} // namespace patina
