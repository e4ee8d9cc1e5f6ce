// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QObject>
#include <QTimer>

namespace patina {

/// Says which frames that take several turns of the event loop go first.
enum class Urgency {
    Sketch,
    Frame,
    Refinement ///< a frame that only adds samples to a picture of the same scene
};

/// Gives the turns of the event loop to the frames of several views, which share one device: one
/// frame after the other, so that the first is done after its own time and not after that of all.
class FrameTurns : public QObject {
    Q_OBJECT

  public:
    /// Holds where a view stands in the queue. It takes part from take() until leave().
    class Place {
      public:
        /// `turns` outlives it; `work` draws one turn of the frame.
        Place(FrameTurns& turns, std::function<void()> work);
        ~Place();
        Place(const Place&) = delete;
        Place& operator=(const Place&) = delete;

        /// Queues behind the frames that are as urgent; who stands in the queue leaves it first.
        void take(Urgency urgency);
        void leave();

      private:
        friend class FrameTurns;

        FrameTurns& turns_;
        std::function<void()> work_;
        Urgency urgency_ = Urgency::Frame;
    };

    FrameTurns();

  private:
    void giveNext();

    std::vector<Place*> queue_;
    QTimer timer_;
};

} // namespace patina
