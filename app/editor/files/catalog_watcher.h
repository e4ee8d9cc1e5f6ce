// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QElapsedTimer>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "catalog/catalog.h"
#include "files/path_states.h"

namespace patina {

/// Reads the catalogue again when a file in one of its folders changes, also when an editor saves
/// by renaming, and when a folder goes, comes back or is replaced by another. A block whose
/// descriptor does not read any more stays as it was.
class CatalogWatcher : public QObject {
    Q_OBJECT

  public:
    /// `catalog` is what the folders hold now.
    explicit CatalogWatcher(std::shared_ptr<const Catalog> catalog, QObject* parent = nullptr);

    /// Starts watching; makes the user's folder if it is not there, so that it can be watched.
    void start();

  Q_SIGNALS:
    /// Comes for every change of a file, also when the blocks read the same: their GLSL may differ.
    void changed(std::shared_ptr<const patina::Catalog> catalog);

  private:
    void settle();
    bool watchAll();
    void read();
    PathStates statesNow() const;

    std::shared_ptr<const Catalog> catalog_;
    PathStates known_;   ///< as they were when they were read
    PathStates watched_; ///< as they were when watching them began
    std::unique_ptr<QFileSystemWatcher> watcher_;
    QElapsedTimer sinceFirst_; ///< change that was not read yet
    QTimer settle_;
};

/// `read`, with the blocks of `before` put back whose descriptors, or the folders that these are
/// in, have mistakes now.
Catalog withLastGoodBlocks(Catalog read, const Catalog& before);

} // namespace patina
