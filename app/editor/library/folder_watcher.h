// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <QObject>
#include <QSocketNotifier>

namespace patina {

/// Tells that something in folders came, went or was written, also in place. The kernel watches
/// folders, not files: thousands of files cost no more than one.
class FolderWatcher : public QObject {
    Q_OBJECT

  public:
    explicit FolderWatcher(QObject* parent = nullptr);
    ~FolderWatcher() override;

    /// Watches these and no others; those below them are watched where they are listed themselves.
    void watch(const std::vector<std::filesystem::path>& folders);

  Q_SIGNALS:
    void changed();

  private:
    void read();
    void close();

    int queue_ = -1; ///< of inotify; -1: none can be had, and nothing is told
    std::unique_ptr<QSocketNotifier> arrived_;
};

} // namespace patina
