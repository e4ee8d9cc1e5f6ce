// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QHash>

#include "library/preset_library.h"

class QLabel;

namespace patina {

class ThumbnailMaker;

/// Shows the variants that changed with a preset that they derive from, each before and after.
class VariantChangesDialog : public QDialog {
    Q_OBJECT

  public:
    VariantChangesDialog(const std::vector<VariantChange>& changes, ThumbnailMaker& thumbnails,
                         QWidget* parent = nullptr);

  private:
    QLabel* pictureOf(const PresetPtr& entry, const QString& said, ThumbnailMaker& thumbnails);

    QHash<QString, QLabel*> pictures_; ///< holds labels that wait for their image, by request name
};

} // namespace patina
