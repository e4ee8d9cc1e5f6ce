// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>

#include "background/worker.h"
#include "catalog/catalog.h"
#include "core/mesh.h"
#include "render/renderer.h"

namespace patina {

/// Makes the programs of frames in a thread with a context of its own, so that the window need not
/// wait for compilers. What comes of it lies in the folder of programs and in the driver's own
/// cache, where the views' contexts find it: such a driver writes it in the background, so a frame
/// is finished only when its context is gone.
class ProgramWorker : public QObject {
    Q_OBJECT

  public:
    /// A frame, apart from what its programs do not depend on.
    struct Frame {
        Scene scene;
        std::optional<Scene> effects; ///< see View::effects
        View view;
        std::vector<Bounds> meshes; ///< by object; empty where there is none yet
        std::int64_t triangles = 0; ///< that are seen
        std::shared_ptr<const Catalog> catalog;
    };

    explicit ProgramWorker(std::filesystem::path programCache, QObject* parent = nullptr);

    /// finished() follows with the number that this returns, also where nothing could be made.
    quint64 ask(Frame frame);

  Q_SIGNALS:
    void finished(quint64 number);

  private:
    std::filesystem::path programCache_;
    quint64 asked_ = 0;
    Worker worker_;
};

} // namespace patina
