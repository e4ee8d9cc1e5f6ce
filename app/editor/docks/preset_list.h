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

/// The presets that a view shows, with the pictures that are there so far. It holds as many of
/// these as are told, the latest ones.
class PresetList : public QAbstractListModel {
    Q_OBJECT

  public:
    explicit PresetList(const PresetMarks& marks, QObject* parent = nullptr);

    void setRows(std::vector<PresetPtr> rows);
    const std::vector<PresetPtr>& rows() const { return rows_; }
    const PresetPtr& entry(const QModelIndex& index) const;
    QModelIndex indexOf(const QString& file) const;
    bool isFavourite(const QModelIndex& index) const;
    /// A second line below the names: the model and the tags.
    void setDetailed(bool detailed);

    /// A picture of this very entry: what its file held before is another look.
    bool hasPicture(const QModelIndex& index) const;
    void setPicture(const PresetPtr& entry, const QIcon& picture);
    void forgetPictures();
    /// They are shown until there are new ones.
    void outdatePictures();
    void setMaxPictures(int count) { pictures_.setMaxCost(count); }
    /// What is shown in place of a picture.
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
    QHash<QString, int> places_;        ///< rows by file
    QCache<QString, Picture> pictures_; ///< by file
    QIcon empty_;
    bool detailed_ = false;
};

/// The tags with a comma between them.
QString joinedTags(const Material& material);

} // namespace patina
