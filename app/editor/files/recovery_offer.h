// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "files/autosave.h"

class QWidget;

namespace patina {

class FileActions;

/// Offers to recover work that an earlier program could not save.
class RecoveryOffer : public QObject {
    Q_OBJECT

  public:
    /// Keeps references that have to outlive it; `window` is the parent of the question.
    RecoveryOffer(Autosave& autosave, DocumentFiles& documentFiles, FileActions& files,
                  QWidget* window);

    /// Asks about the newest copy, and about the next one if that is discarded. Does nothing
    /// without copies.
    void ask();

  private:
    void recover(const Recovery& recovery);

    Autosave& autosave_;
    DocumentFiles& documentFiles_;
    FileActions& files_;
    QWidget* window_;
};

} // namespace patina
