// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/preset_list.h"

#include <algorithm>

#include <QMimeData>
#include <QUrl>

namespace patina {

PresetList::PresetList(const PresetMarks& marks, QObject* parent)
    : QAbstractListModel(parent), marks_(marks) {
    connect(&marks, &PresetMarks::changed, this, [this] {
        if (!rows_.empty()) {
            Q_EMIT dataChanged(index(0), index(rowCount() - 1));
        }
    });
}

void PresetList::setRows(std::vector<PresetPtr> rows) {
    beginResetModel();
    rows_ = std::move(rows);
    places_.clear();
    for (const PresetPtr& entry : rows_) {
        places_.insert(entry->path, static_cast<int>(places_.size()));
    }
    endResetModel();
}

const PresetPtr& PresetList::entry(const QModelIndex& index) const {
    return rows_.at(static_cast<std::size_t>(index.row()));
}

QModelIndex PresetList::indexOf(const QString& file) const {
    const auto found = places_.find(file);
    return found == places_.end() ? QModelIndex() : index(*found);
}

bool PresetList::isFavourite(const QModelIndex& index) const {
    return marks_.isFavourite(entry(index)->path);
}

void PresetList::setDetailed(bool detailed) {
    detailed_ = detailed;
}

bool PresetList::hasPicture(const QModelIndex& index) const {
    const PresetPtr& shown = entry(index);
    const Picture* picture = pictures_.object(shown->path);
    return picture && picture->of == shown && !picture->outdated;
}

void PresetList::setPicture(const PresetPtr& entry, const QIcon& picture) {
    pictures_.insert(entry->path, new Picture{picture, entry, false});
    const QModelIndex changed = indexOf(entry->path);
    if (changed.isValid()) {
        Q_EMIT dataChanged(changed, changed, {Qt::DecorationRole});
    }
}

void PresetList::forgetPictures() {
    pictures_.clear();
}

void PresetList::outdatePictures() {
    for (const QString& file : pictures_.keys()) {
        pictures_.object(file)->outdated = true;
    }
}

int PresetList::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant PresetList::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const PresetEntry& shown = *entry(index);
    const auto details = [&shown] {
        const QString tags = joinedTags(shown.material);
        return tags.isEmpty() ? shown.modelLabel : shown.modelLabel + QStringLiteral(" · ") + tags;
    };
    switch (role) {
    case Qt::DisplayRole:
        return detailed_ ? shown.name + QChar::LineSeparator + details() : shown.name;
    case Qt::DecorationRole: {
        const Picture* picture = pictures_.object(shown.path);
        const bool isOfItsLook =
            picture && (picture->of == entry(index) || picture->of->material == shown.material);
        return isOfItsLook ? picture->icon : empty_;
    }
    case Qt::AccessibleTextRole:
        return shown.name;
    case Qt::AccessibleDescriptionRole:
        return isFavourite(index) ? tr("%1, a favourite").arg(details()) : details();
    default:
        return {};
    }
}

Qt::ItemFlags PresetList::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractListModel::flags(index);
    return index.isValid() ? flags | Qt::ItemIsDragEnabled | Qt::ItemNeverHasChildren : flags;
}

QStringList PresetList::mimeTypes() const {
    return {QStringLiteral("text/uri-list")};
}

QMimeData* PresetList::mimeData(const QModelIndexList& indexes) const {
    QList<QUrl> files;
    for (const QModelIndex& index : indexes) {
        files << QUrl::fromLocalFile(entry(index)->path);
    }
    auto* dragged = new QMimeData;
    dragged->setUrls(files);
    return dragged;
}

QString joinedTags(const Material& material) {
    QStringList words;
    for (const std::string& tag : material.tags) {
        words << QString::fromStdString(tag);
    }
    return words.join(QStringLiteral(", "));
}

} // namespace patina
