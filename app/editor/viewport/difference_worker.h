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

/// Holds frames of A and B, of the same size, in linear light after exposure, with four channels.
struct ComparedFrames {
    Image a;
    Image b;
    FrameDifference difference;
};

/// Holds the same frames as a display shows them, values 0 .. 1.
struct ShownPair {
    Image a;
    Image b;
};

/// Holds what was drawn; both are null where nothing can be drawn.
struct DrawnPair {
    std::shared_ptr<const ComparedFrames> frames;
    std::shared_ptr<const ShownPair> shown;
};

/// Says how long a frame of B takes as a multiple of the time of one of A.
struct TimeRatio {
    MedianInterval ratio;
    int pairs = 0; ///< counts the pairs of frames, each drawn one after the other
};

/// Draws both sides of a comparison and computes their difference, in a thread with a context of
/// its own. It uses 32-bit floats unless the sides differ in their number format, as half floats
/// are too coarse for small differences; each side keeps its own number of environment directions
/// where these differ. The context is released when there was nothing to do for some seconds. Every
/// request can be cancelled by the Progress that is returned.
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
        MeshSource meshes; ///< has to be usable in other threads, as have the next two
        TextureSource textures;
        std::shared_ptr<const Catalog> catalog;
    };

    explicit DifferenceWorker(std::filesystem::path programCache, QObject* parent = nullptr);

    ~DifferenceWorker() override;

    /// Asks for frames in place of a request that was not begun yet; finished() follows for the
    /// last one. A frame that is being drawn then stops taking further environment directions once
    /// it has enough to show anything.
    std::shared_ptr<Progress> ask(Request request);

    /// Measures how far the frames are apart; `done` gets nothing where that was cancelled.
    std::shared_ptr<Progress>
    askDistance(std::shared_ptr<const ComparedFrames> frames,
                std::shared_ptr<const ShownPair> shown,
                std::function<void(const std::optional<PictureDistance>&)> done);

    /// Times frames of A and B in turns, for about a second; `done` gets nothing where that was
    /// cancelled or cannot be done. Frames that take long are drawn smaller than the request says.
    std::shared_ptr<Progress> askTime(Request request,
                                      std::function<void(const std::optional<TimeRatio>&)> done);

  Q_SIGNALS:
    /// Is sent when a request is done; `problem` says why nothing was drawn, and is empty
    /// otherwise. `isLast`: no other request has been made since.
    void finished(const patina::DrawnPair& drawn, const QString& problem, bool isLast);

  private:
    class Workshop;

    Result<DrawnPair> draw(const Request& request, const Worker::Control& control);
    std::optional<TimeRatio> time(const Request& request, const Worker::Control& control);

    std::filesystem::path programCache_;
    int asked_ = 0; ///< counts the requests for frames
    std::unique_ptr<Workshop> workshop_; ///< belongs to the worker's thread
    Worker worker_;
};

} // namespace patina
