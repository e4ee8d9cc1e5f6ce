// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QAbstractListModel>
#include <QCache>
#include <QHash>
#include <QIcon>

#include "library/preset_marks.h"
#include "library/preset_query.h"

namespace patina {

/// Is the model of the presets that a view shows, with their images. It keeps a limited number of
/// images, those used last.
class PresetList : public QAbstractListModel {
    Q_OBJECT

  public:
    explicit PresetList(const PresetMarks& marks, QObject* parent = nullptr);

    void setRows(std::vector<PresetPtr> rows);
    const std::vector<PresetPtr>& rows() const { return rows_; }
    const PresetPtr& entry(const QModelIndex& index) const;
    QModelIndex indexOf(const QString& file) const;
    bool isFavourite(const QModelIndex& index) const;
    /// Adds a second line below the names: the model and the tags.
    void setDetailed(bool detailed);

    /// Returns whether there is an up-to-date image of this very entry. An entry that was read
    /// again from its file counts as another one.
    bool hasPicture(const QModelIndex& index) const;
    void setPicture(const PresetPtr& entry, const QIcon& picture);
    void forgetPictures();
    /// Marks all images as outdated; they are shown until there are new ones.
    void outdatePictures();
    void setMaxPictures(int count) { pictures_.setMaxCost(count); }
    /// Sets what is shown for presets without an image.
    void setEmptyPicture(const QIcon& picture) { empty_ = picture; }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    QStringList mimeTypes() const override;

  private:
    struct Picture {
        QIcon icon;
        PresetPtr of;
        bool outdated = false;
    };

    const PresetMarks& marks_;
    std::vector<PresetPtr> rows_;
    QHash<QString, int> places_;        ///< holds rows by file
    QCache<QString, Picture> pictures_; ///< holds images by file
    QIcon empty_;
    bool detailed_ = false;
};

/// Returns the tags separated by commas.
QString joinedTags(const Material& material);

} // namespace patina
