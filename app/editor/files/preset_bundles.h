// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QObject>

#include "background/worker.h"
#include "bundle/preset_bundle.h"
#include "library/preset_entry.h"

namespace patina {

class ThumbnailMaker;

/// Exports presets into bundles with a picture of each, and imports bundles, in the background.
class PresetBundles : public QObject {
    Q_OBJECT

  public:
    explicit PresetBundles(ThumbnailMaker& thumbnails, QObject* parent = nullptr);

    /// Exports presets into a zip file; cancels an export whose pictures are still being drawn.
    void exportTo(const QString& file, const std::vector<PresetPtr>& entries);
    void cancelExport();
    /// Imports a bundle into a new folder below `folder`.
    void importFrom(const QString& file, const std::filesystem::path& folder);

  Q_SIGNALS:
    void drawn(int pictures, int of);
    void exported(const QString& file, const std::vector<patina::BundleOutcome>& outcomes);
    void imported(const QString& folder, const std::vector<patina::BundleOutcome>& outcomes);
    void failed(const patina::Error& why);

  private:
    void take(const QString& name, const QImage& picture);
    void write();

    ThumbnailMaker& thumbnails_;
    QString file_; ///< is that of the running export
    std::vector<BundledPreset> presets_;
    QHash<QString, std::size_t> asked_; ///< holds indices into presets_ by request name
    int lastAsked_ = 0;
    Worker worker_;
};

} // namespace patina
