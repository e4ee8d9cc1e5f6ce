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
/// wait for compilers. The programs are stored in the folder of programs and in the driver's own
/// cache, where the views' contexts find them. Some drivers write their cache in the background, so
/// a frame is finished only when its context is destroyed.
class ProgramWorker : public QObject {
    Q_OBJECT

  public:
    /// Holds what the programs of a frame depend on.
    struct Frame {
        Scene scene;
        std::optional<Scene> effects; ///< see View::effects
        View view;
        /// Holds one box per object; empty where the mesh is not there yet.
        std::vector<Bounds> meshes;
        std::int64_t triangles = 0; ///< counts the triangles of all visible objects
        std::shared_ptr<const Catalog> catalog;
    };

    explicit ProgramWorker(std::filesystem::path programCache, QObject* parent = nullptr);

    /// Asks for the programs of a frame and returns a number; finished() follows with it, also
    /// where nothing could be made, or givenUp().
    quint64 ask(Frame frame);

  Q_SIGNALS:
    void finished(quint64 number);
    void givenUp(quint64 number); ///< the user cancelled it: some programs are missing

  private:
    std::filesystem::path programCache_;
    quint64 asked_ = 0;
    Worker worker_;
};

} // namespace patina
