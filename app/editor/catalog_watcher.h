// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "catalog/catalog.h"

namespace patina {

/// Reads the catalogue again when a file in one of its folders changes, also when an editor saves
/// by renaming. A block whose descriptor does not read any more stays as it was.
class CatalogWatcher : public QObject {
    Q_OBJECT

  public:
    explicit CatalogWatcher(std::shared_ptr<const Catalog> catalog, QObject* parent = nullptr);

    /// Starts watching; makes the user's folder if it is not there, so that it can be watched.
    void start();

    /// Reads the catalogue again at the end of this event-loop turn.
    void reload();

  Q_SIGNALS:
    /// Comes for every change of a file, also when the blocks read the same: their GLSL may differ.
    void changed(std::shared_ptr<const patina::Catalog> catalog);

  private:
    void watchAll();
    void read();

    std::shared_ptr<const Catalog> catalog_;
    std::unique_ptr<QFileSystemWatcher> watcher_;
    QTimer settle_;
};

/// `read`, with the blocks of `before` put back whose descriptors have mistakes now.
Catalog withLastGoodBlocks(Catalog read, const Catalog& before);

} // namespace patina
