// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include "background/worker.h"
#include "library/folder_watcher.h"
#include "library/preset_marks.h"
#include "library/preset_reader.h"

namespace patina {

/// Holds a variant before and after a preset that it derives from changed.
struct VariantChange {
    PresetPtr before;
    PresetPtr after;
};

/// Holds the presets that ship, those in the user's folder and those in folders that the user
/// added. A worker thread reads them, and again when a file in one of the folders changes.
class PresetLibrary : public QObject {
    Q_OBJECT

  public:
    PresetLibrary(std::shared_ptr<const Catalog> catalog, Session& session,
                  QObject* parent = nullptr);

    /// Returns the presets sorted by name; more and more of them while folders are read for the
    /// first time.
    const std::vector<PresetPtr>& entries() const { return entries_; }
    PresetPtr find(const QString& file) const;
    /// Returns false until the folders were read for the first time.
    bool isRead() const { return isRead_; }
    void setCatalog(std::shared_ptr<const Catalog> catalog);
    PresetMarks& marks() { return marks_; }
    const Catalog& catalog() const { return *catalog_; }

    /// Returns the shipped folder, the user's, and those that were added.
    std::vector<PresetFolder> folders() const;
    void addFolder(const QString& folder);
    /// Takes a folder out of the library, but leaves it on the disk.
    void removeFolder(const QString& folder);

    /// Reads all folders; checked() follows, and changed() if the presets differ.
    void scan();

    static std::filesystem::path shippedFolder();
    static std::filesystem::path userFolder();

  Q_SIGNALS:
    void changed();
    /// Is emitted when variants look different although only a preset that they derive from
    /// changed.
    void variantsChanged(const std::vector<patina::VariantChange>& changes);
    /// Is emitted when all files were read; files with mistakes are not among the entries.
    void checked(patina::Errors mistakes);

  private:
    void tellVariants(const std::vector<PresetPtr>& entries);
    void setEntries(const std::vector<PresetPtr>& entries);
    void watch();

    Session& session_;
    std::shared_ptr<const Catalog> catalog_;
    PresetMarks marks_;
    std::vector<PresetPtr> entries_;
    bool isRead_ = false;
    bool isOfCatalog_ = false; ///< tells whether the entries were read with the current blocks
    std::vector<std::filesystem::path> watched_; ///< are all folders that were read
    FolderWatcher watcher_;
    QTimer settle_;
    Worker worker_;
};

} // namespace patina
