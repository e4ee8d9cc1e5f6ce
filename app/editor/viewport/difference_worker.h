// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include <QObject>

#include "background/worker.h"
#include "measure/error/frame_difference.h"
#include "measure/error/picture_distance.h"
#include "measure/time/median_interval.h"
#include "render/renderer.h"

namespace patina {

/// Frames of A and B, in linear light with the exposure in it, with four channels.
struct ComparedFrames {
    Image a;
    Image b;
    FrameDifference difference;
};

/// The same frames as a display shows them, values 0 .. 1.
struct ShownPair {
    Image a;
    Image b;
};

/// What was drawn; null where it cannot be.
struct DrawnPair {
    std::shared_ptr<const ComparedFrames> frames;
    std::shared_ptr<const ShownPair> shown;
};

/// What a frame of B takes of the time of one of A.
struct TimeRatio {
    MedianInterval ratio;
    int pairs = 0; ///< of frames, one after the other
};

/// Draws both sides of a comparison and takes one from the other, in a thread with a context of its
/// own: in whole floats unless the sides differ in that, as half floats are too coarse for small
/// differences; with the sides' own numbers of an environment's directions where these differ. The
/// context goes when there was nothing to do for some seconds. All that is asked for can be given
/// up by the Progress that is returned.
class DifferenceWorker : public QObject {
    Q_OBJECT

  public:
    /// Holds what one side shows.
    struct Side {
        Scene scene;
        std::optional<Scene> effects; ///< see View::effects
        /// See View::environmentImage.
        std::shared_ptr<const EnvironmentImage> environment;
    };
    struct Request {
        Side a;
        Side b;
        View view;
        MeshSource meshes; ///< for other threads, as are the next
        TextureSource textures;
        std::shared_ptr<const Catalog> catalog;
    };

    explicit DifferenceWorker(std::filesystem::path programCache, QObject* parent = nullptr);

    ~DifferenceWorker() override;

    /// Asks in place of what was asked for and not begun yet; finished() follows for the last. Of
    /// an environment what is being drawn takes no more directions then than it takes to show
    /// anything.
    std::shared_ptr<Progress> ask(Request request);

    /// Measures how far the frames are apart; nothing where that was given up.
    std::shared_ptr<Progress>
    askDistance(std::shared_ptr<const ComparedFrames> frames,
                std::shared_ptr<const ShownPair> shown,
                std::function<void(const std::optional<PictureDistance>&)> done);

    /// Times frames of A and B in turns, about a second long; nothing where that was given up or
    /// cannot be done. They are smaller than what is asked for where they take long.
    std::shared_ptr<Progress> askTime(Request request,
                                      std::function<void(const std::optional<TimeRatio>&)> done);

  Q_SIGNALS:
    /// Says why where nothing was drawn.
    void finished(const patina::DrawnPair& drawn, const QString& problem);

  private:
    class Workshop;

    Result<DrawnPair> draw(const Request& request, const Worker::Control& control);
    std::optional<TimeRatio> time(const Request& request, const Worker::Control& control);

    std::filesystem::path programCache_;
    std::unique_ptr<Workshop> workshop_; ///< of the worker's thread
    Worker worker_;
};

} // namespace patina
