// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include "render/view.h"

namespace patina {

class ViewedScene;

/// Decides how frames take the light of an environment: fitted while something changes, and sampled
/// little by little once nothing does any more, without a jump in brightness.
class SampleRefinement : public QObject {
    Q_OBJECT

  public:
    /// `viewed` outlives this.
    explicit SampleRefinement(const ViewedScene& viewed);

    /// Decides how the next frame is drawn. `isChanged`: something has changed since the last one,
    /// which has so many `samples` of the environment.
    void beginFrame(bool isChanged, int samples);

    /// Tells whether the frame only adds samples to a picture of the same scene.
    bool isAtRest() const { return isAtRest_; }

    /// Tells whether the frame goes on with the samples of the last one.
    bool isContinued() const { return isContinued_; }

    /// Returns the view as the frame is drawn.
    View drawn(View view) const;

    /// Returns the share of the frame in what is on the screen from now on, 0 .. 1: at rest the
    /// fitted picture leaves as samples come. It counts the frame, so it is asked once.
    double nextShare(int samples);

    /// Tells whether a picture of so many samples is to be refined.
    bool wantsMore(int samples) const;

    /// Asks for the next frame that adds samples, after one that shows the scene as it is.
    void continueSoon(int samples);

    /// Forgets the last frame, since another picture is drawn in its place.
    void forgetFrame();

  Q_SIGNALS:
    void due(); ///< the next frame that adds samples may be drawn

  private:
    const ViewedScene& viewed_;
    QTimer timer_;
    bool isMoving_ = false;    ///< the frame's light is fitted, because something has changed
    bool isAtRest_ = false;    ///< nothing has changed since the frame before
    bool isContinued_ = false; ///< the frame adds samples to those of the one before
    int mixed_ = 0; ///< counts the samples that have taken the fitted picture's place on the screen
};

} // namespace patina
