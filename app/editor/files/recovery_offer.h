// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "files/autosave.h"

class QWidget;

namespace patina {

class FileActions;

/// Offers work that an earlier program could not save.
class RecoveryOffer : public QObject {
    Q_OBJECT

  public:
    /// All outlive it; `window` is what the question lies over.
    RecoveryOffer(Autosave& autosave, DocumentFiles& documentFiles, FileActions& files,
                  QWidget* window);

    /// Asks about the newest, and about the next where that is discarded. Nothing happens where
    /// there is none.
    void ask();

  private:
    void recover(const Recovery& recovery);

    Autosave& autosave_;
    DocumentFiles& documentFiles_;
    FileActions& files_;
    QWidget* window_;
};

} // namespace patina
