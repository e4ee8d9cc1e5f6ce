// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <QDateTime>
#include <QObject>
#include <QTimer>

#include "document/document.h"
#include "window/single_thread.h"

class QLockFile;

namespace patina {

/// Work that a program which is gone had not saved.
struct Recovery {
    std::filesystem::path scene;
    DocumentFile original; ///< the file it was opened from or saved to last, if any
    QDateTime saved;
};

/// Keeps a copy of unsaved work on disk, a few seconds behind, so that not even a kill loses it.
/// A lock beside each copy tells whether its program still runs.
class Autosave : public QObject {
    Q_OBJECT

  public:
    Autosave(Document& document, std::filesystem::path folder, QObject* parent = nullptr);
    ~Autosave() override;

    /// How long after the last change, and how long after the first one at most.
    void setIntervals(int quietMs, int longestMs);

    /// Makes what was recovered this program's copy.
    void adopt(const Recovery& recovery);

    /// Removes the copy: the work is saved.
    void discard();

    /// Removes the copy, but not of work that was recovered: that is offered until it is saved or
    /// given up where it is offered.
    void giveUp();

    /// What can be recovered, newest first.
    static std::vector<Recovery> found(const std::filesystem::path& folder);
    static void remove(const Recovery& recovery);

  Q_SIGNALS:
    void failed(patina::Error why);

  private:
    void stop();
    void schedule();
    void save();
    bool takeStem();

    Document& document_;
    std::filesystem::path folder_;
    std::filesystem::path stem_;
    std::unique_ptr<QLockFile> lock_;
    bool isAdopted_ = false;
    QTimer quiet_;
    QTimer longest_;
    SingleThread worker_{1000};
};

} // namespace patina
