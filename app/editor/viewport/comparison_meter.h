// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QObject>
#include <QTimer>

#include "viewport/difference_worker.h"
#include "viewport/side_view.h"

namespace patina {

/// Holds how far another side is from A; what is not measured yet is empty.
struct ComparisonNumbers {
    Side other = Side::B;
    std::optional<PictureDistance> distance;
    std::optional<TimeRatio> time;
};

/// Measures how far A is from the active side, or from B while A is active, seen by A's camera,
/// while the document compares. Frames are drawn as soon as something changes while somebody looks
/// at their difference; otherwise, and for all numbers, it waits until nothing has changed for a
/// moment. Measurements that a change makes out of date are cancelled.
class ComparisonMeter : public QObject {
    Q_OBJECT

  public:
    /// `first` is side A's view.
    ComparisonMeter(const ViewSources& sources, const Viewport& first, QObject* parent = nullptr);

    /// Sets how many pixels show the difference; empty while nobody looks at it.
    void setPictureSize(const QSize& pixels);

    /// Returns the frames that were drawn last; null before the first ones and where they cannot be
    /// drawn.
    const ComparedFrames* frames() const { return frames_.get(); }
    /// Says why there are no frames; empty where there is no problem.
    const QString& problem() const { return problem_; }
    /// Tells whether the frames are of A and B as they are now.
    bool isUpToDate() const { return frames_ && !settle_.isActive() && !areFramesAsked_; }

    /// Returns the side that is compared with A.
    Side other() const;

    /// Returns the numbers of both sides as they are now, as far as they are measured.
    const ComparisonNumbers& numbers() const { return numbers_; }

  Q_SIGNALS:
    void framesChanged();
    void numbersChanged();

  private:
    void followChange();
    DifferenceWorker::Request request();
    DifferenceWorker::Side sideOf(Side side);
    void giveUp();
    void askFrames();
    void take(const DrawnPair& drawn, const QString& problem, bool isLast);
    void rest();

    Document& document_;
    const Viewport& first_;
    MeshLibrary& meshes_;
    TextureLibrary& textures_;
    EnvironmentLibrary& environments_;
    EffectSwitches& switches_;
    DifferenceWorker worker_;
    QTimer settle_; ///< gathers changes before frames are asked for
    QTimer rest_;   ///< ends when nothing has changed for a moment
    QSize pictureSize_;
    bool areFramesAsked_ = false;
    bool areStale_ = true; ///< the frames are out of date, and no new ones were asked for
    /// Cancels what is being measured; null before the first time.
    std::shared_ptr<Progress> measuring_;
    std::shared_ptr<const ComparedFrames> frames_;
    /// Holds the frames until they are measured; then null.
    std::shared_ptr<const ShownPair> shown_;
    QString problem_;
    ComparisonNumbers numbers_;
};

} // namespace patina
