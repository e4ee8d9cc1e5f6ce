// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/outside_consent.h"

#include <algorithm>

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "files/key_pause.h"

namespace patina {
namespace {

constexpr std::size_t maxNamed = 8; // files that the question itself names

QString text(const char* words) {
    return QObject::tr(words);
}

QString kindText(OutsideFile::Kind kind) {
    switch (kind) {
    case OutsideFile::Kind::Mesh:
        return text("the mesh");
    case OutsideFile::Kind::Picture:
        return text("the picture");
    case OutsideFile::Kind::Preset:
        return text("the preset");
    case OutsideFile::Kind::Link:
        return text("the mesh's file");
    default:
        return text("the image");
    }
}

QString lines(const OutsideFiles& files, std::size_t maxLines) {
    QStringList lines;
    for (const OutsideFile& each : files) {
        if (static_cast<std::size_t>(lines.size()) == maxLines) {
            lines << text("and %1 more").arg(files.size() - maxLines);
            break;
        }
        lines << kindText(each.kind) + ' ' + QString::fromStdString(each.file);
    }
    return lines.join('\n');
}

QStringList pathsOf(const OutsideFiles& files) {
    QStringList paths;
    for (const OutsideFile& each : files) {
        paths << QString::fromStdString(each.file);
    }
    return paths;
}

QString fullPath(const QString& file) {
    return file.isEmpty() ? file : QFileInfo(file).absoluteFilePath();
}

} // namespace

ReadingRights OutsideConsent::rightsFor(const QString& file, DocumentFile::Kind kind,
                                        const Catalog& catalog) {
    ReadingRights rights;
    for (const QString& other : session_.outside(fullPath(file), true)) {
        rights.allowed.insert(other.toStdString());
    }
    while (true) { // files that are allowed may name others
        OutsideFiles wanted = DocumentFiles::outsideOf(file.toStdString(), kind, catalog, rights);
        const QStringList refused = session_.outside(fullPath(file), false);
        std::erase_if(wanted, [&](const OutsideFile& each) {
            return refused.contains(QString::fromStdString(each.file));
        });
        if (wanted.empty() || !ask(file, wanted)) {
            return rights;
        }
        for (const OutsideFile& each : wanted) {
            rights.allowed.insert(each.file);
        }
    }
}

bool OutsideConsent::ask(const QString& file, const OutsideFiles& wanted) {
    const QString name = file.isEmpty() ? text("The document") : QFileInfo(file).fileName();
    QMessageBox question(QMessageBox::Question, text("Files outside the folder"),
                         text("%1 names files outside its folder. Read them?").arg(name),
                         QMessageBox::Yes | QMessageBox::No, window_);
    question.setInformativeText(lines(wanted, maxNamed));
    if (wanted.size() > maxNamed) {
        question.setDetailedText(lines(wanted, wanted.size()));
    }
    question.setTextFormat(Qt::PlainText);
    question.button(QMessageBox::Yes)->setText(text("&Allow"));
    question.button(QMessageBox::No)->setText(text("&Leave out"));
    question.setDefaultButton(QMessageBox::No);
    new KeyPause(question);
    const bool allowed = question.exec() == QMessageBox::Yes;
    if (!file.isEmpty()) {
        session_.addOutside(fullPath(file), allowed, pathsOf(wanted));
    }
    return allowed;
}

void OutsideConsent::noteSaved(const QString& file, DocumentFile::Kind kind, const Catalog& catalog,
                               const WithheldFiles& withheld) {
    const OutsideFiles refused = withheld.all();
    OutsideFiles own = DocumentFiles::outsideOf(file.toStdString(), kind, catalog, {});
    std::erase_if(own, [&](const OutsideFile& each) {
        return std::ranges::find(refused, each) != refused.end();
    });
    if (kind == DocumentFile::Kind::Scene) {
        for (const std::string& link : withheld.rights().links) {
            own.push_back({OutsideFile::Kind::Link, link});
        }
    }
    if (!own.empty()) {
        session_.addOutside(fullPath(file), true, pathsOf(own));
    }
}

} // namespace patina
