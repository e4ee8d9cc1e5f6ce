// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/chart_export.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QSaveFile>

#include "session.h"

namespace patina {

QString askForChartFile(QWidget* parent, const QString& ending) {
    Session session;
    QFileDialog dialog(parent,
                       QCoreApplication::translate("ChartExport", "Export what was measured"),
                       session.folder("chart"),
                       QStringLiteral("%1 (*.%2)").arg(ending.toUpper(), ending));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(ending);
    dialog.selectFile("accuracy." + ending);
    if (dialog.exec() != QDialog::Accepted) {
        return {};
    }
    const QString file = dialog.selectedFiles().value(0);
    session.setFolderOf("chart", file);
    return file;
}

Result<void> writeWhole(const QString& file, const QByteArray& bytes) {
    QSaveFile target(file);
    if (target.open(QIODevice::WriteOnly) && target.write(bytes) == bytes.size() &&
        target.commit()) {
        return {};
    }
    return tl::unexpected(
        Error{file.toStdString(), 0, 0, target.errorString().toStdString(), {}});
}

} // namespace patina
