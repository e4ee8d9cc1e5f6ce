// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/material_exporter.h"

#include <QFileDialog>
#include <QFileInfo>
#include <fmt/format.h>

#include "files/save_actions.h"

namespace patina {
namespace {

/// Returns what became of a material as notes on the file, without what is exactly the same.
Errors notesOn(const QString& file, const MaterialExport& exported) {
    Errors notes;
    for (const ExportLine& line : exported.lines.front()) {
        if (line.kept != Kept::Exact) {
            notes.push_back({file.toStdString(),
                             0,
                             0,
                             fmt::format("{}: {}, {}", wordOf(line.kept), line.what, line.how),
                             {}});
        }
    }
    return notes;
}

QString filterOf(const ExchangeFormat& format) {
    return QString("%1 (*%2)")
        .arg(QLatin1String(format.label.data(), qsizetype(format.label.size())),
             QLatin1String(format.ending.data(), qsizetype(format.ending.size())));
}

} // namespace

MaterialExporter::MaterialExporter(Session& session, QWidget* window)
    : QObject(window), session_(session), window_(window) {}

void MaterialExporter::ask(const Material& material, std::shared_ptr<const Catalog> catalog) {
    QStringList filters;
    for (const ExchangeFormat& format : exchangeFormats()) {
        filters << filterOf(format);
    }
    QFileDialog dialog(window_, tr("Export the material for other programs"),
                       session_.folder("material"), filters.join(";;"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    const auto setSuffix = [&dialog](const QString& filter) {
        for (const ExchangeFormat& format : exchangeFormats()) {
            if (filterOf(format) == filter) {
                dialog.setDefaultSuffix(QString::fromStdString(std::string(format.ending)).mid(1));
            }
        }
    };
    connect(&dialog, &QFileDialog::filterSelected, &dialog, setSuffix);
    setSuffix(filters.front());
    dialog.selectFile(SaveActions::asFileName(QString::fromStdString(material.name)));
    if (dialog.exec() == QDialog::Accepted) {
        const QString file = dialog.selectedFiles().value(0);
        session_.setFolderOf("material", file);
        write(file, material, std::move(catalog));
    }
}

void MaterialExporter::write(const QString& file, const Material& material,
                             std::shared_ptr<const Catalog> catalog) {
    worker_.ask(
        [file, material, catalog = std::move(catalog)](Worker::Control& control) {
            return exportMaterials(file.toStdString(), {material}, *catalog, control.progress());
        },
        [this, file](const Result<MaterialExport>& exported) {
            if (exported) {
                Q_EMIT written(file, notesOn(file, *exported));
            } else if (exported.error().problem != cancelledExport) {
                Q_EMIT failed(exported.error());
            }
        },
        {}, QFileInfo(file).fileName());
}

} // namespace patina
