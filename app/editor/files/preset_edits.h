// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QObject>
#include <QStringList>
#include <QUndoStack>

#include "library/preset_entry.h"

namespace patina {

class PresetLibrary;
class PresetFilesCommand;
struct PresetFileChange;

/// What became of one preset in an edit.
struct PresetOutcome {
    PresetPtr entry;
    std::string problem; ///< empty: it was done

    bool isDone() const { return problem.empty(); }
};

/// Edits preset files: names, tags, copies, favourites, and puts them into the trash. Each edit is
/// one undo step, however many presets it is for, and tells what became of each. Files that come
/// with Patina stay as they are. A preset that is renamed keeps its file, so that variants and
/// scenes find it.
class PresetEdits : public QObject {
    Q_OBJECT

  public:
    explicit PresetEdits(PresetLibrary& presets, QObject* parent = nullptr);

    void rename(const PresetPtr& entry, const QString& name);
    void duplicate(const std::vector<PresetPtr>& entries);
    /// Makes a variant of each, which looks like it at first.
    void makeVariants(const std::vector<PresetPtr>& entries);
    /// Makes variants presets of their own, which look as they do and follow no parent any more.
    void detach(const std::vector<PresetPtr>& entries);
    void moveToTrash(const std::vector<PresetPtr>& entries);
    /// Adds tags to each and takes others away.
    void changeTags(const std::vector<PresetPtr>& entries, const QStringList& added,
                    const QStringList& removed);
    void setFavourites(const std::vector<PresetPtr>& entries, bool on);
    /// Has an import that made this folder taken back like an edit.
    void noteImport(const QString& folder);

    QUndoStack& undoStack() { return undoStack_; }

  Q_SIGNALS:
    /// An edit, its undo or its redo was tried.
    void done(const QString& what, const std::vector<patina::PresetOutcome>& outcomes);
    /// An import could not be taken back, or not be made again.
    void importFailed(const QString& folder, const QString& problem);

  private:
    friend class PresetFilesCommand;
    friend class ImportCommand;

    void addCopies(const std::vector<PresetPtr>& entries, const QString& what, const QString& name,
                   bool asVariants);
    void push(const QString& what, std::vector<PresetOutcome> refused,
              std::vector<PresetFileChange> changes);

    PresetLibrary& presets_;
    QUndoStack undoStack_;
};

} // namespace patina
