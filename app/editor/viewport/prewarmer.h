// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QObject>
#include <QTimer>

#include "viewport/frame_loop.h"
#include "viewport/ordered_programs.h"

namespace patina {

/// Has the programs made of scenes that a view may soon show, one scene at a time while the view
/// has nothing to draw.
class Prewarmer : public QObject {
    Q_OBJECT

  public:
    /// Both references outlive it.
    Prewarmer(FrameLoop& frames, const ViewedScene& viewed);

    /// Says that a frame of this scene may soon be wanted.
    void add(const Scene& ahead);

    /// Tells whether something is still to be made.
    bool isBusy() const { return !ahead_.empty(); }

  private:
    /// Describes a frame: a scene, drawn as it is while it changes or as at rest.
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
    std::vector<Ahead> ahead_; ///< holds the frames whose programs are still to be made
    OrderedPrograms programs_; ///< orders the programs of the last of them
    QTimer turn_;              ///< runs one of them per turn of the event loop
};

} // namespace patina
