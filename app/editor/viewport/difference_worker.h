// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>

#include <QObject>

#include "background/background_job.h"
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
    /// What one side shows.
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

    /// Gives up what it works on.
    ~DifferenceWorker() override;

    /// Asks in place of what was asked for and not begun yet; finished() follows for the last.
    void ask(Request request);

    /// Something else will be asked for: of an environment no more directions are drawn than it
    /// takes to show anything.
    void hurry();

    /// Whether nothing is asked for that is not finished.
    bool isIdle() const { return asked_ == answered_; }

  Q_SIGNALS:
    /// Null where the frames cannot be drawn, and why.
    void finished(std::shared_ptr<const patina::FrameDifference> difference, QString problem);

  private:
    class Workshop;
    struct Job {
        quint64 number = 0;
        Request request;
    };

    void wake();
    void work();
    std::optional<Job> next();
    void answer(quint64 number, const Result<FrameDifference>& difference);

    std::filesystem::path programCache_;
    quint64 asked_ = 0;
    quint64 answered_ = 0;
    std::mutex mutex_; ///< guards the four below, which the thread shares
    std::optional<Job> job_;
    bool isEnding_ = false;
    bool isHurried_ = false;
    std::condition_variable news_;
    BackgroundJob worker_; ///< the last: it ends before what it uses
};

} // namespace patina
