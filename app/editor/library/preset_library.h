// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "background/worker.h"
#include "catalog/catalog.h"
#include "material/material.h"

namespace patina {

/// A preset file that can be read.
struct PresetEntry {
    std::filesystem::path file;
    Material material;
    bool shipped = true;

    friend bool operator==(const PresetEntry&, const PresetEntry&) = default;
};

/// The presets that ship and those in the user's folder, read in a worker thread and again when
/// a file in one of the folders comes, goes or changes.
class PresetLibrary : public QObject {
    Q_OBJECT

  public:
    explicit PresetLibrary(std::shared_ptr<const Catalog> catalog, QObject* parent = nullptr);

    const std::vector<PresetEntry>& entries() const { return entries_; }
    /// False until the folders were read for the first time.
    bool isRead() const { return isRead_; }
    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Reads all folders; changed() follows.
    void scan();

    static std::filesystem::path shippedFolder();
    static std::filesystem::path userFolder();

  Q_SIGNALS:
    void changed();
    /// All files were read; these mistakes keep some of them out of the entries.
    void checked(patina::Errors mistakes);

  private:
    void watchAll();

    std::shared_ptr<const Catalog> catalog_;
    std::vector<PresetEntry> entries_;
    bool isRead_ = false;
    std::unique_ptr<QFileSystemWatcher> watcher_;
    QTimer settle_;
    Worker worker_;
};

} // namespace patina
