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

/// Work that a program which is gone had not saved.
struct Recovery {
    std::filesystem::path scene;
    DocumentFile original; ///< the file it was opened from or saved to last, if any
    QDateTime saved;
};

/// Keeps unsaved work on disk, a fifth of a second behind, so that a kill loses no more than the
/// edit under the hand. A lock beside each copy tells whether its program still runs.
class Autosave : public QObject {
    Q_OBJECT

  public:
    Autosave(Document& document, DocumentFiles& files, std::filesystem::path folder,
             QObject* parent = nullptr);
    ~Autosave() override;

    /// Returns where the copies are.
    const std::filesystem::path& folder() const { return folder_; }

    /// Sets how long after the last change, and how long after the first one at most.
    void setIntervals(int quietMs, int longestMs);

    /// Puts the last edits into a copy that is to be recovered. Where that fails, which is said,
    /// the copy stays as it was some edits before.
    void complete(const Recovery& recovery);

    /// Makes what was recovered this program's copy.
    void adopt(const Recovery& recovery);

    /// Removes the copy: the work is saved.
    void discard();

    /// Removes the copy, but not of work that was recovered: that is offered until it is saved or
    /// given up where it is offered.
    void giveUp();

    /// Returns what can be recovered, newest first.
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
    std::unique_ptr<EditJournal> journal_; ///< used in the worker alone
    bool isAdopted_ = false;
    bool hasFailed_ = false; ///< and said so
    QTimer quiet_;
    QTimer longest_;
    Worker worker_{{.name = tr("Keeping unsaved work safe"), .atEnd = Worker::AtEnd::Finish}};
};

} // namespace patina
