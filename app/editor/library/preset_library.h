// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include "background/worker.h"
#include "library/folder_watcher.h"
#include "library/preset_marks.h"
#include "library/preset_reader.h"

namespace patina {

/// A variant before and after a preset above it changed.
struct VariantChange {
    PresetPtr before;
    PresetPtr after;
};

/// The presets that ship, those in the user's folder and those in folders that the user added, read
/// in a worker thread and again when a file in one of the folders comes, goes or changes.
class PresetLibrary : public QObject {
    Q_OBJECT

  public:
    PresetLibrary(std::shared_ptr<const Catalog> catalog, Session& session,
                  QObject* parent = nullptr);

    /// Sorted by name. While the folders are read for the first time there are more and more.
    const std::vector<PresetPtr>& entries() const { return entries_; }
    PresetPtr find(const QString& file) const;
    /// False until the folders were read for the first time.
    bool isRead() const { return isRead_; }
    void setCatalog(std::shared_ptr<const Catalog> catalog);
    PresetMarks& marks() { return marks_; }
    const Catalog& catalog() const { return *catalog_; }

    /// The shipped one, the user's, and those that were added.
    std::vector<PresetFolder> folders() const;
    void addFolder(const QString& folder);
    /// The folder stays where it is; it is no longer shown.
    void removeFolder(const QString& folder);

    /// Reads all folders; changed() follows.
    void scan();

    static std::filesystem::path shippedFolder();
    static std::filesystem::path userFolder();

  Q_SIGNALS:
    void changed();
    /// These variants look otherwise though their own files did not change: a preset above them
    /// did.
    void variantsChanged(const std::vector<patina::VariantChange>& changes);
    /// All files were read; these mistakes keep some of them out of the entries.
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
    bool isOfCatalog_ = false; ///< the entries were read with the blocks that there are now
    std::vector<std::filesystem::path> watched_; ///< and the folders that these lie in
    FolderWatcher watcher_;
    QTimer settle_;
    Worker worker_;
};

} // namespace patina
