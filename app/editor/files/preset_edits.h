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

/// Says what became of one preset in an edit.
struct PresetOutcome {
    PresetPtr entry;
    std::string problem; ///< is empty if it was done

    bool isDone() const { return problem.empty(); }
};

/// Edits preset files: names, tags, copies, favourites, and moves them to the trash. Each edit is
/// one undo step for any number of presets, and reports on each. Files that come with Patina are
/// never changed. A renamed preset keeps its file, so that variants and scenes still find it.
class PresetEdits : public QObject {
    Q_OBJECT

  public:
    explicit PresetEdits(PresetLibrary& presets, QObject* parent = nullptr);

    /// Gives each a name in which {name} stands for the one that it has and {n} for its place among
    /// them from 1 on. Several get their numbers behind a name without either.
    void rename(const std::vector<PresetPtr>& entries, const QString& pattern);
    void duplicate(const std::vector<PresetPtr>& entries);
    /// Makes a variant of each, which looks the same at first.
    void makeVariants(const std::vector<PresetPtr>& entries);
    /// Turns variants into presets that look the same and have no parent.
    void detach(const std::vector<PresetPtr>& entries);
    void moveToTrash(const std::vector<PresetPtr>& entries);
    /// Adds tags to each preset and removes others.
    void changeTags(const std::vector<PresetPtr>& entries, const QStringList& added,
                    const QStringList& removed);
    void setFavourites(const std::vector<PresetPtr>& entries, bool on);
    /// Makes the import that created this folder undoable.
    void noteImport(const QString& folder);

    QUndoStack& undoStack() { return undoStack_; }

  Q_SIGNALS:
    /// Is emitted after an edit, its undo or its redo, with the outcome of each preset.
    void done(const QString& what, const std::vector<patina::PresetOutcome>& outcomes);
    /// Is emitted if an import could not be undone or redone.
    void importFailed(const QString& folder, const QString& problem);

  private:
    friend class PresetFilesCommand;
    friend class ImportCommand;

    void addCopies(const std::vector<PresetPtr>& entries, const QString& what, const QString& name,
                   bool asVariants);
    std::string variantsBeside(const PresetEntry& parent,
                               const std::vector<PresetPtr>& others) const;
    void push(const QString& what, std::vector<PresetOutcome> refused,
              std::vector<PresetFileChange> changes);

    PresetLibrary& presets_;
    QUndoStack undoStack_;
};

} // namespace patina
