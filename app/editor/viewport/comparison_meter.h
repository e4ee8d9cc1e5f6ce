// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QObject>
#include <QTimer>

#include "viewport/difference_worker.h"
#include "viewport/side_view.h"

namespace patina {

/// Holds what is known of how far another side is from A.
struct ComparisonNumbers {
    Side other = Side::B;
    std::optional<PictureDistance> distance;
    std::optional<TimeRatio> time;
};

/// Measures how far A and the active side, or B, are apart, seen from where A looks, while the
/// document compares: the frames as soon as something changes where somebody looks at their
/// difference, and else, with all numbers, when nothing has changed for a moment. What has become
/// needless is given up.
class ComparisonMeter : public QObject {
    Q_OBJECT

  public:
    /// `first` is side A's view.
    ComparisonMeter(const ViewSources& sources, const Viewport& first, QObject* parent = nullptr);

    /// The difference is looked at, in so many pixels; empty: it is not.
    void setPictureSize(const QSize& pixels);

    /// Returns what was drawn last; null before that.
    const ComparedFrames* frames() const { return frames_.get(); }
    /// Why it is not there.
    const QString& problem() const { return problem_; }
    /// Tells whether the frames are of A and B as they are now.
    bool isUpToDate() const { return frames_ && !settle_.isActive() && !areFramesAsked_; }

    /// The side that is compared with A.
    Side other() const;

    /// Returns what is known of both as they are now.
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
    void take(const DrawnPair& drawn, const QString& problem);
    void rest();

    Document& document_;
    const Viewport& first_;
    MeshLibrary& meshes_;
    TextureLibrary& textures_;
    EnvironmentLibrary& environments_;
    EffectSwitches& switches_;
    DifferenceWorker worker_;
    QTimer settle_; ///< changes are gathered
    QTimer rest_;   ///< nothing changes any more
    QSize pictureSize_;
    bool areFramesAsked_ = false;
    bool areStale_ = true;                ///< the frames are not of what there is now
    std::shared_ptr<Progress> measuring_; ///< what numbers come from
    std::shared_ptr<const ComparedFrames> frames_;
    std::shared_ptr<const ShownPair> shown_; ///< until they are measured
    QString problem_;
    ComparisonNumbers numbers_;
};

} // namespace patina
