// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/preset_library.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <QDir>
#include <QDirIterator>

#include "material/preset_file.h"
#include "session.h"

namespace patina {
namespace {

constexpr int settleMs = 200;
const QString presetPattern = QStringLiteral("*.patina.json");

QString text(const std::filesystem::path& path) {
    return QString::fromStdString(path.string());
}

void readFolder(const std::filesystem::path& folder, bool shipped, const Catalog& catalog,
                std::vector<PresetEntry>& entries) {
    QDirIterator walk(text(folder), {presetPattern}, QDir::Files, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        const std::filesystem::path file = walk.next().toStdString();
        if (Checked<PresetReading> reading = readPreset(file, catalog)) {
            entries.push_back({file, std::move(reading->material), shipped});
        }
    }
}

std::vector<PresetEntry> readAll(const Catalog& catalog) {
    std::vector<PresetEntry> entries;
    readFolder(PresetLibrary::shippedFolder(), true, catalog, entries);
    readFolder(PresetLibrary::userFolder(), false, catalog, entries);
    std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
        return QString::localeAwareCompare(QString::fromStdString(a.material.name),
                                           QString::fromStdString(b.material.name)) < 0;
    });
    return entries;
}

QStringList foldersBelow(const std::filesystem::path& top) {
    if (!QDir(text(top)).exists()) {
        return {};
    }
    QStringList folders{text(top)};
    QDirIterator walk(text(top), QDir::Dirs | QDir::NoDotAndDotDot, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        folders << walk.next();
    }
    return folders;
}

} // namespace

PresetLibrary::PresetLibrary(std::shared_ptr<const Catalog> catalog, QObject* parent)
    : QObject(parent), catalog_(std::move(catalog)) {
    worker_.setMaxThreadCount(1);
    worker_.setExpiryTimeout(1000);
    settle_.setSingleShot(true);
    settle_.setInterval(settleMs);
    connect(&settle_, &QTimer::timeout, this, &PresetLibrary::scan);
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, &settle_,
            qOverload<>(&QTimer::start));
}

PresetLibrary::~PresetLibrary() {
    worker_.clear();
    worker_.waitForDone();
}

void PresetLibrary::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
    settle_.start();
}

void PresetLibrary::scan() {
    std::error_code ignored; // a folder that cannot be made has no presets in it
    std::filesystem::create_directories(userFolder(), ignored);
    watchFolders();
    worker_.start([this, catalog = catalog_] {
        auto read = std::make_shared<std::vector<PresetEntry>>(readAll(*catalog));
        const auto take = [this, read] {
            if (*read != entries_) {
                entries_ = std::move(*read);
                Q_EMIT changed();
            }
        };
        QMetaObject::invokeMethod(this, take, Qt::QueuedConnection);
    });
}

std::filesystem::path PresetLibrary::shippedFolder() {
    return dataFolder() / "presets";
}

std::filesystem::path PresetLibrary::userFolder() {
    return userDataFolder() / "presets";
}

void PresetLibrary::watchFolders() {
    const QStringList wanted = foldersBelow(shippedFolder()) + foldersBelow(userFolder());
    const QStringList watched = watcher_.directories();
    for (const QString& folder : wanted) {
        if (!watched.contains(folder)) {
            watcher_.addPath(folder);
        }
    }
}

} // namespace patina
