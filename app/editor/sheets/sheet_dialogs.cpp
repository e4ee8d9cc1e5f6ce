// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheets/sheet_dialogs.h"

#include <QFileDialog>

#include "session/session.h"
#include "sheet/sheet_file.h"
#include "text/as_text.h"

namespace patina {
namespace {

constexpr const char* purpose = "sheet"; ///< names the folder that is remembered

QString ending() {
    return asText(std::string(sheetEnding));
}

QString sheetFilter() {
    return QObject::tr("Contact sheets (*%1)").arg(ending());
}

QString chosenIn(QFileDialog& dialog, Session& session) {
    if (dialog.exec() != QDialog::Accepted) {
        return {};
    }
    const QString file = dialog.selectedFiles().value(0);
    session.setFolderOf(purpose, file);
    return file;
}

} // namespace

QString askForSheet(QWidget* parent, Session& session) {
    QFileDialog dialog(parent, QObject::tr("Open contact sheet"), session.folder(purpose),
                       sheetFilter());
    dialog.setFileMode(QFileDialog::ExistingFile);
    return chosenIn(dialog, session);
}

QString askWhereToSaveSheet(QWidget* parent, Session& session, const QString& name) {
    QFileDialog dialog(parent, QObject::tr("Save contact sheet"), session.folder(purpose),
                       sheetFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(ending().mid(1));
    dialog.selectFile(name + ending());
    return chosenIn(dialog, session);
}

QString askWhereToExportSheet(QWidget* parent, Session& session, const QString& name) {
    const QString png = QObject::tr("PNG, as on the screen (*.png)");
    const QString exr = QObject::tr("OpenEXR, linear floats (*.exr)");
    const QString csv = QObject::tr("Table of numbers (*.csv)");
    QFileDialog dialog(parent, QObject::tr("Export contact sheet"), session.folder(purpose),
                       QStringList{png, exr, csv}.join(";;"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix("png");
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString& filter) {
        dialog.setDefaultSuffix(filter == csv ? "csv" : filter == exr ? "exr" : "png");
    });
    dialog.selectFile(name + ".png");
    return chosenIn(dialog, session);
}

} // namespace patina
