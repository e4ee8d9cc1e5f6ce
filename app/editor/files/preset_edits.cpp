// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/preset_edits.h"

#include <algorithm>
#include <functional>
#include <optional>

#include <QFile>
#include <QFileInfo>
#include <QUndoCommand>

#include "catalog/json_text.h"
#include "core/atomic_file.h"
#include "core/ordinary_file.h"
#include "library/preset_library.h"
#include "material/file_suffixes.h"
#include "material/variant.h"

namespace patina {

/// Holds a file before and after an edit; a state is empty where the file does not exist.
struct PresetFileChange {
    PresetPtr entry; ///< is the preset that is reported
    std::filesystem::path file;
    std::optional<std::string> before;
    std::optional<std::string> after;
    QString trashed{}; ///< is its path in the trash
};

namespace {

namespace fs = std::filesystem;

const char* const shippedProblem = "it comes with Patina and stays as it is";

std::optional<std::string> contentOf(const fs::path& file) {
    Result<std::string> content = readFile(file, maxAssetBytes);
    return content ? std::optional(std::move(*content)) : std::nullopt;
}

std::string asProblem(const Error& error) {
    return error.expected.empty() ? error.problem : error.problem + "; " + error.expected;
}

bool toTrash(const QString& path, QString& trashed) {
    return QFile::moveToTrash(path, &trashed);
}

/// Moves a file or folder back from the trash, if its old path is free.
bool fromTrash(QString& trashed, const QString& path) {
    if (trashed.isEmpty() || !QFile::rename(trashed, path)) {
        return false;
    }
    const QFileInfo file(trashed);
    QFile::remove(QStringLiteral("%1/../info/%2.trashinfo").arg(file.path(), file.fileName()));
    trashed.clear();
    return true;
}

/// Brings a file from one state to the other, unless somebody else has changed it. Returns the
/// problem, or an empty text.
std::string bring(PresetFileChange& change, const std::optional<std::string>& from,
                  const std::optional<std::string>& to) {
    if (contentOf(change.file) != from) {
        return from ? "its file was changed meanwhile" : "there is another file of its name";
    }
    const QString file = QString::fromStdString(change.file.string());
    if (!to) {
        return toTrash(file, change.trashed) ? std::string()
                                             : "the file could not be moved to the trash";
    }
    if (!from && fromTrash(change.trashed, file)) {
        return {};
    }
    const Result<void> written = writeFileAtomically(change.file, *to);
    return written ? std::string() : asProblem(written.error());
}

/// Returns the text of a preset file after an edit of its JSON object.
Result<std::string> edited(const fs::path& file,
                           const std::function<void(nlohmann::json& preset)>& edit) {
    Result<LocatedJson> document = readJson(file);
    if (!document) {
        return tl::unexpected(document.error());
    }
    if (!document->value.is_object()) {
        return failure("it is no preset");
    }
    edit(document->value);
    return writeJson(document->value);
}

/// Returns a path beside the file, or in the user's folder for a shipped one, that no file has.
fs::path placeForCopy(const PresetEntry& entry, const std::string& ending,
                      const std::vector<PresetFileChange>& others) {
    const fs::path folder = entry.shipped ? PresetLibrary::userFolder() : entry.file.parent_path();
    const std::string name = entry.file.filename().string();
    const std::string suffix(presetSuffix);
    const std::string stem = name.substr(0, name.size() - suffix.size());
    for (int number = 1;; ++number) {
        const fs::path place =
            folder / (stem + ending + (number > 1 ? std::to_string(number) : "") + suffix);
        const bool isTaken = std::ranges::any_of(
            others, [&place](const PresetFileChange& other) { return other.file == place; });
        std::error_code unreadable;
        if (!isTaken && !fs::exists(place, unreadable)) {
            return place;
        }
    }
}

/// Marks presets as favourites, or unmarks them.
class FavouritesCommand : public QUndoCommand {
  public:
    FavouritesCommand(PresetMarks& marks, QStringList files, bool on)
        : marks_(marks), files_(std::move(files)), on_(on) {}

    void redo() override { marks_.setFavourites(files_, on_); }
    void undo() override { marks_.setFavourites(files_, !on_); }

  private:
    PresetMarks& marks_;
    QStringList files_;
    bool on_;
};

} // namespace

/// Changes files and undoes that. A file that could not be changed is left out of undo.
class PresetFilesCommand : public QUndoCommand {
  public:
    PresetFilesCommand(PresetEdits& edits, const QString& what, std::vector<PresetOutcome> refused,
                       std::vector<PresetFileChange> changes)
        : QUndoCommand(what), edits_(edits), refused_(std::move(refused)),
          changes_(std::move(changes)) {}

    void redo() override {
        run(text(),
            [](PresetFileChange& change) { return bring(change, change.before, change.after); });
    }
    void undo() override {
        run(QObject::tr("Undo: %1").arg(text()),
            [](PresetFileChange& change) { return bring(change, change.after, change.before); });
    }

  private:
    void run(const QString& what, std::string (*change)(PresetFileChange&)) {
        std::vector<PresetOutcome> outcomes = std::exchange(refused_, {});
        std::vector<PresetFileChange> kept;
        for (PresetFileChange& each : changes_) {
            outcomes.push_back({each.entry, change(each)});
            if (outcomes.back().isDone()) {
                kept.push_back(std::move(each));
            }
        }
        changes_ = std::move(kept);
        setObsolete(changes_.empty());
        edits_.presets_.scan();
        Q_EMIT edits_.done(what, outcomes);
    }

    PresetEdits& edits_;
    std::vector<PresetOutcome> refused_; ///< holds outcomes that are reported with the first run
    std::vector<PresetFileChange> changes_;
};

/// Moves the folder of an import to the trash and back.
class ImportCommand : public QUndoCommand {
  public:
    ImportCommand(PresetEdits& edits, const QString& folder)
        : QUndoCommand(QObject::tr("Import into %1").arg(QFileInfo(folder).fileName())),
          edits_(edits), folder_(folder) {}

    void redo() override {
        if (std::exchange(isNew_, false)) {
            return;
        }
        report(fromTrash(trashed_, folder_) ? QString() : QObject::tr("it is not in the trash"));
    }
    void undo() override {
        report(toTrash(folder_, trashed_) ? QString()
                                          : QObject::tr("it could not be moved to the trash"));
    }

  private:
    void report(const QString& problem) {
        setObsolete(!problem.isEmpty());
        edits_.presets_.scan();
        if (!problem.isEmpty()) {
            Q_EMIT edits_.importFailed(folder_, problem);
        }
    }

    PresetEdits& edits_;
    QString folder_;
    QString trashed_;
    bool isNew_ = true; ///< skips the first redo, as the import is already done
};

PresetEdits::PresetEdits(PresetLibrary& presets, QObject* parent)
    : QObject(parent), presets_(presets) {}

void PresetEdits::push(const QString& what, std::vector<PresetOutcome> refused,
                       std::vector<PresetFileChange> changes) {
    undoStack_.push(new PresetFilesCommand(*this, what, std::move(refused), std::move(changes)));
}

namespace {

/// Collects the files to edit, and the presets that are refused.
struct Prepared {
    std::vector<PresetOutcome> refused;
    std::vector<PresetFileChange> changes;

    void add(const PresetPtr& entry, const std::function<void(nlohmann::json& preset)>& edit) {
        if (entry->shipped) {
            refused.push_back({entry, shippedProblem});
            return;
        }
        const std::optional<std::string> before = contentOf(entry->file);
        const Result<std::string> after = edited(entry->file, edit);
        if (!before || !after) {
            refused.push_back({entry, after ? "its file is gone" : asProblem(after.error())});
        } else if (*before != *after) {
            changes.push_back({entry, entry->file, before, *after});
        }
    }
};

} // namespace

void PresetEdits::rename(const std::vector<PresetPtr>& entries, const QString& pattern) {
    const QString oldName = QStringLiteral("{name}");
    const QString number = QStringLiteral("{n}");
    const bool tellsApart =
        entries.size() == 1 || pattern.contains(oldName) || pattern.contains(number);
    const QString names = tellsApart ? pattern : pattern + QStringLiteral(" {n}");
    Prepared prepared;
    int place = 0;
    for (const PresetPtr& entry : entries) {
        QString name = names;
        name.replace(number, QString::number(++place)).replace(oldName, entry->name);
        prepared.add(entry,
                     [&name](nlohmann::json& preset) { preset["name"] = name.toStdString(); });
    }
    if (!prepared.changes.empty() || !prepared.refused.empty()) {
        push(entries.size() == 1 ? tr("Rename %1").arg(entries.front()->name)
                                 : tr("Rename %1 presets").arg(entries.size()),
             std::move(prepared.refused), std::move(prepared.changes));
    }
}

void PresetEdits::duplicate(const std::vector<PresetPtr>& entries) {
    addCopies(entries, entries.size() == 1 ? tr("Duplicate %1") : tr("Duplicate %1 presets"),
              tr("%1 copy"), false);
}

void PresetEdits::makeVariants(const std::vector<PresetPtr>& entries) {
    addCopies(entries, entries.size() == 1 ? tr("Variant of %1") : tr("Variants of %1 presets"),
              tr("%1 variant"), true);
}

void PresetEdits::detach(const std::vector<PresetPtr>& entries) {
    Prepared prepared;
    for (const PresetPtr& entry : entries) {
        if (parentOf(entry->material).empty()) {
            continue;
        }
        Material whole = entry->material;
        patina::setParent(whole, {});
        prepared.add(entry, [&](nlohmann::json& preset) {
            preset = presetJson(whole, entry->file, presets_.catalog());
        });
    }
    if (!prepared.changes.empty() || !prepared.refused.empty()) {
        push(entries.size() == 1 ? tr("Detach %1").arg(entries.front()->name)
                                 : tr("Detach %1 presets").arg(entries.size()),
             std::move(prepared.refused), std::move(prepared.changes));
    }
}

void PresetEdits::addCopies(const std::vector<PresetPtr>& entries, const QString& what,
                            const QString& name, bool asVariants) {
    std::vector<PresetFileChange> changes;
    for (const PresetPtr& entry : entries) {
        Material copy = entry->material;
        copy.name = name.arg(entry->name).toStdString();
        const fs::path file = placeForCopy(*entry, asVariants ? "-variant" : "-copy", changes);
        if (asVariants) {
            patina::setParent(copy, entry->file.generic_string());
        }
        changes.push_back(
            {entry, file, std::nullopt, writeJson(presetJson(copy, file, presets_.catalog()))});
    }
    if (!changes.empty()) {
        const QString of =
            entries.size() == 1 ? entries.front()->name : QString::number(entries.size());
        push(what.arg(of), {}, std::move(changes));
    }
}

/// Returns the names of the variants of a preset that are not among others; empty for none.
std::string PresetEdits::variantsBeside(const PresetEntry& parent,
                                        const std::vector<PresetPtr>& others) const {
    std::string names;
    for (const PresetPtr& each : presets_.entries()) {
        const std::filesystem::path file = parentOf(each->material);
        if (file == parent.file && std::ranges::none_of(others, [&each](const PresetPtr& other) {
                return other->file == each->file;
            })) {
            names += (names.empty() ? "" : ", ") + each->name.toStdString();
        }
    }
    return names;
}

void PresetEdits::moveToTrash(const std::vector<PresetPtr>& entries) {
    Prepared prepared;
    for (const PresetPtr& entry : entries) {
        const std::optional<std::string> before = contentOf(entry->file);
        if (entry->shipped) {
            prepared.refused.push_back({entry, shippedProblem});
        } else if (!before) {
            prepared.refused.push_back({entry, "its file is gone"});
        } else if (const std::string variants = variantsBeside(*entry, entries);
                   !variants.empty()) {
            prepared.refused.push_back(
                {entry, "it is the parent of " + variants +
                            ": move these to the trash with it, or detach them before"});
        } else {
            prepared.changes.push_back({entry, entry->file, before, std::nullopt});
        }
    }
    if (!entries.empty()) {
        push(entries.size() == 1 ? tr("Move %1 to the trash").arg(entries.front()->name)
                                 : tr("Move %1 presets to the trash").arg(entries.size()),
             std::move(prepared.refused), std::move(prepared.changes));
    }
}

void PresetEdits::changeTags(const std::vector<PresetPtr>& entries, const QStringList& added,
                             const QStringList& removed) {
    Prepared prepared;
    for (const PresetPtr& entry : entries) {
        std::vector<std::string> tags = entry->material.tags;
        std::erase_if(tags, [&removed](const std::string& tag) {
            return removed.contains(QString::fromStdString(tag));
        });
        for (const QString& tag : added) {
            if (std::ranges::find(tags, tag.toStdString()) == tags.end()) {
                tags.push_back(tag.toStdString());
            }
        }
        if (tags != entry->material.tags) {
            prepared.add(entry, [&tags](nlohmann::json& preset) { preset["tags"] = tags; });
        }
    }
    if (!prepared.changes.empty() || !prepared.refused.empty()) {
        push(entries.size() == 1 ? tr("Tag %1").arg(entries.front()->name)
                                 : tr("Tag %1 presets").arg(entries.size()),
             std::move(prepared.refused), std::move(prepared.changes));
    }
}

void PresetEdits::setFavourites(const std::vector<PresetPtr>& entries, bool on) {
    QStringList files;
    for (const PresetPtr& entry : entries) {
        if (presets_.marks().isFavourite(entry->path) != on) {
            files << entry->path;
        }
    }
    if (!files.isEmpty()) {
        auto* command = new FavouritesCommand(presets_.marks(), files, on);
        command->setText(on ? tr("Mark as favourite") : tr("No favourite any more"));
        undoStack_.push(command);
    }
}

void PresetEdits::noteImport(const QString& folder) {
    undoStack_.push(new ImportCommand(*this, folder));
}

} // namespace patina
