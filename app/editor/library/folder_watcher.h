// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <QObject>
#include <QSocketNotifier>

namespace patina {

/// Emits changed() when something in a folder is added, removed or written. It watches folders, not
/// files, so that thousands of files cost no more than one.
class FolderWatcher : public QObject {
    Q_OBJECT

  public:
    explicit FolderWatcher(QObject* parent = nullptr);
    ~FolderWatcher() override;

    /// Watches these folders in place of the former ones; folders below them only if they are
    /// listed.
    void watch(const std::vector<std::filesystem::path>& folders);

  Q_SIGNALS:
    void changed();

  private:
    void read();
    void close();

    int queue_ = -1; ///< is inotify's descriptor; -1 without one, and nothing is emitted
    std::unique_ptr<QSocketNotifier> arrived_;
};

} // namespace patina
