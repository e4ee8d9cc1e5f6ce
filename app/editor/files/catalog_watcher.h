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

/// Reads the catalogue again when a file in one of its folders changes, even if an editor saves by
/// renaming, and when a folder is removed, restored or replaced. A block whose descriptor can no
/// longer be read stays as it was.
class CatalogWatcher : public QObject {
    Q_OBJECT

  public:
    /// `catalog` holds what is in its folders now.
    explicit CatalogWatcher(std::shared_ptr<const Catalog> catalog, QObject* parent = nullptr);

    /// Starts watching; creates the user's folder if it does not exist, so that it can be watched.
    void start();

  Q_SIGNALS:
    /// Is emitted for every change of a file, even if the blocks read the same, as their GLSL may
    /// differ.
    void changed(std::shared_ptr<const patina::Catalog> catalog);

  private:
    void settle();
    bool watchAll();
    void read();
    PathStates statesNow() const;

    std::shared_ptr<const Catalog> catalog_;
    PathStates known_;   ///< holds the states at the last reading
    PathStates watched_; ///< holds the states when watching began
    std::unique_ptr<QFileSystemWatcher> watcher_;
    QElapsedTimer sinceFirst_; ///< runs since the first change that was not read yet
    QTimer settle_;
};

/// Returns `read` with blocks of `before` that cannot be read any more, because their descriptors
/// or the folders of these have errors now.
Catalog withLastGoodBlocks(Catalog read, const Catalog& before);

} // namespace patina
