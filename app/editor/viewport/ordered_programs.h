// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QObject>

#include "render/frame/frame_job.h"
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

    /// Has the programs of a frame of a scene made; came() or givenUp() follows unless others are
    /// ordered meanwhile.
    void order(const Scene& scene, const View& view);
    void forget() { number_ = 0; }

    /// Tells whether a frame of the scene waits for programs; then they are ordered, and came()
    /// follows unless others are ordered meanwhile. It never waits where nothing can be
    /// ordered, and not for what came and is missing still: neither driver nor disk kept
    /// that, so it is made where the frame is drawn.
    bool mustWait(FrameJob& job, const Scene& scene, const View& view);

  Q_SIGNALS:
    void came();    ///< is sent when all programs that could be made are there
    void givenUp(); ///< is sent in its place when the user cancelled that

  private:
    void take(quint64 number);
    void giveUp(quint64 number);

    const ViewedScene& viewed_;
    quint64 number_ = 0; ///< is what ProgramWorker::ask() returned; 0 while nothing is awaited
    std::uint64_t missing_ = 0; ///< hashes the programs that were ordered; 0: none were
};

} // namespace patina
