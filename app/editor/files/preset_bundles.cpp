// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/preset_bundles.h"

#include <QImage>

#include "library/thumbnail_maker.h"
#include "text/png.h"

namespace patina {
namespace {

/// Returns the name of a preset's file without its two suffixes.
std::string fileStem(const std::filesystem::path& file) {
    return file.stem().stem().string();
}

} // namespace

PresetBundles::PresetBundles(ThumbnailMaker& thumbnails, QObject* parent)
    : QObject(parent), thumbnails_(thumbnails),
      worker_({.name = tr("Presets in a zip file"), .atEnd = Worker::AtEnd::Finish}) {
    connect(&thumbnails, &ThumbnailMaker::ready, this, &PresetBundles::take);
}

void PresetBundles::exportTo(const QString& file, const std::vector<PresetPtr>& entries) {
    cancelExport();
    file_ = file;
    for (const PresetPtr& entry : entries) {
        const QString name = QStringLiteral("bundle/%1").arg(++lastAsked_);
        asked_[name] = presets_.size();
        presets_.push_back({fileStem(entry->file), entry->material});
        thumbnails_.ask(name, entry->material);
    }
}

void PresetBundles::cancelExport() {
    asked_.clear();
    presets_.clear();
}

/// Writes the bundle after the last picture. A preset that cannot be drawn has none.
void PresetBundles::take(const QString& name, const QImage& picture) {
    const auto place = asked_.find(name);
    if (place == asked_.end()) {
        return;
    }
    presets_.at(*place).picture = picture.isNull() ? std::string() : asPng(picture).toStdString();
    asked_.erase(place);
    const auto all = static_cast<int>(presets_.size());
    Q_EMIT drawn(all - static_cast<int>(asked_.size()), all);
    if (asked_.empty() && !presets_.empty()) {
        write();
    }
}

void PresetBundles::write() {
    worker_.ask([file = file_.toStdString(), presets = std::move(presets_)](
                    Worker::Control&) { return exportBundle(file, presets); },
                [this, file = file_](const Result<std::vector<BundleOutcome>>& outcomes) {
                    if (outcomes) {
                        Q_EMIT exported(file, *outcomes);
                    } else {
                        Q_EMIT failed(outcomes.error());
                    }
                });
    presets_.clear();
}

void PresetBundles::importFrom(const QString& file, const std::filesystem::path& folder) {
    worker_.ask([file = file.toStdString(),
                 folder](Worker::Control&) { return importBundle(file, folder); },
                [this](const Result<BundleImport>& import) {
                    if (import) {
                        Q_EMIT imported(QString::fromStdString(import->folder.string()),
                                        import->outcomes);
                    } else {
                        Q_EMIT failed(import.error());
                    }
                });
}

} // namespace patina
