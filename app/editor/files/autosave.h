// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <QDateTime>
#include <QObject>
#include <QTimer>

#include "background/worker.h"
#include "document/document_files.h"
#include "files/edit_journal.h"

class QLockFile;

namespace patina {

/// Describes unsaved work of a program that ended without saving it.
struct Recovery {
    std::filesystem::path scene;
    DocumentFile original; ///< is what it was opened from or last saved to
    QDateTime saved;
};

/// Keeps a copy of unsaved work on disk, at most 200 ms behind, so that a crash loses no more than
/// the last edit. A lock file beside each copy tells whether its program still runs.
class Autosave : public QObject {
    Q_OBJECT

  public:
    Autosave(Document& document, DocumentFiles& files, std::filesystem::path folder,
             QObject* parent = nullptr);
    ~Autosave() override;

    /// Returns the folder of the copies.
    const std::filesystem::path& folder() const { return folder_; }

    /// Sets how long to wait after the last change, and how long at most after the first one.
    void setIntervals(int quietMs, int longestMs);

    /// Applies the journal to a copy that is to be recovered. If that fails, failed() is emitted
    /// and the copy stays some edits behind.
    void complete(const Recovery& recovery);

    /// Makes a recovered copy this program's own copy.
    void adopt(const Recovery& recovery);

    /// Removes the copy, since the work is saved.
    void discard();

    /// Removes the copy. The copy of recovered work is kept, as it is offered again until it is
    /// saved or discarded there.
    void giveUp();

    /// Returns the copies whose programs do not run any more, newest first.
    static std::vector<Recovery> found(const std::filesystem::path& folder);
    static void remove(const Recovery& recovery);

  Q_SIGNALS:
    void failed(patina::Error why);

  private:
    void stop();
    void giveUpOwn();
    void schedule();
    void save();
    void noteEnd(const Result<void>& written);
    bool takeStem();

    Document& document_;
    DocumentFiles& files_;
    std::filesystem::path folder_;
    std::filesystem::path stem_;
    std::unique_ptr<QLockFile> lock_;
    std::unique_ptr<EditJournal> journal_; ///< is used in the worker only
    bool isAdopted_ = false;
    bool hasFailed_ = false; ///< is set once failed() was emitted, until a copy is written again
    QTimer quiet_;
    QTimer longest_;
    Worker worker_{{.name = tr("Keeping unsaved work safe"), .atEnd = Worker::AtEnd::Finish}};
};

} // namespace patina
