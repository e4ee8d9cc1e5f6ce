// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include <QObject>

#include "background/worker.h"
#include "measure/error/frame_difference.h"
#include "render/renderer.h"

namespace patina {

/// Draws both sides of a comparison and takes one from the other, in a thread with a context of its
/// own: in whole floats unless the sides differ in that, as half floats are too coarse for small
/// differences; with the sides' own numbers of an environment's directions where these differ. The
/// context goes when there was nothing to do for some seconds.
class DifferenceWorker : public QObject {
    Q_OBJECT

  public:
    /// Holds what one side shows.
    struct Side {
        Scene scene;
        std::optional<Scene> effects; ///< see View::effects
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
    void ask(Request request);

    /// Tells whether nothing is asked for that is not finished.
    bool isIdle() const { return worker_.isIdle(); }

  Q_SIGNALS:
    /// Null where the frames cannot be drawn, and why.
    void finished(std::shared_ptr<const patina::FrameDifference> difference, QString problem);

  private:
    using Answer = Result<std::shared_ptr<const FrameDifference>>;
    class Workshop;

    Answer draw(const Request& request, const Worker::Control& control);

    std::filesystem::path programCache_;
    std::unique_ptr<Workshop> workshop_; ///< of the worker's thread
    Worker worker_;
};

} // namespace patina
