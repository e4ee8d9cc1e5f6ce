// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/recovery_offer.h"

#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

#include "files/file_actions.h"
#include "files/key_pause.h"

namespace patina {

RecoveryOffer::RecoveryOffer(Autosave& autosave, DocumentFiles& documentFiles, FileActions& files,
                             QWidget* window)
    : QObject(window), autosave_(autosave), documentFiles_(documentFiles), files_(files),
      window_(window) {}

void RecoveryOffer::ask() {
    const std::vector<Recovery> found = Autosave::found(autosave_.folder());
    if (found.empty()) {
        return;
    }
    const Recovery& newest = found.front();
    auto* question =
        new QMessageBox(QMessageBox::Question, tr("Recover unsaved work"),
                        tr("Patina did not close properly. There is unsaved work from %1.")
                            .arg(QLocale().toString(newest.saved, QLocale::ShortFormat)),
                        QMessageBox::NoButton, window_);
    question->setObjectName("recovery");
    question->setAttribute(Qt::WA_DeleteOnClose);
    const QString file = QString::fromStdString(newest.original.path.string());
    question->setInformativeText(file.isEmpty() ? tr("It was not saved to a file yet.")
                                                : tr("It belongs to %1, which stays as it is until "
                                                     "you save.")
                                                      .arg(file));
    QPushButton* take = question->addButton(tr("Recover"), QMessageBox::AcceptRole);
    QPushButton* drop = question->addButton(tr("Discard"), QMessageBox::DestructiveRole);
    question->addButton(tr("Ask again later"), QMessageBox::RejectRole);
    question->setDefaultButton(take);
    new KeyPause(*question);
    connect(take, &QPushButton::clicked, this, [this, newest] { recover(newest); });
    connect(drop, &QPushButton::clicked, this, [this, newest] {
        Autosave::remove(newest);
        ask();
    });
    question->open();
}

void RecoveryOffer::recover(const Recovery& recovery) {
    if (!files_.saving().mayLoseDocument()) {
        return;
    }
    autosave_.complete(recovery);
    if (documentFiles_.recover(recovery.scene, recovery.original)) {
        autosave_.giveUp();
        autosave_.adopt(recovery);
    }
}

} // namespace patina
