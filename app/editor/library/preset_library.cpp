// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/preset_library.h"

#include <algorithm>
#include <utility>

#include <QDir>
#include <QDirIterator>
#include <QFileInfo>

#include "material/preset_file.h"
#include "session/session.h"

namespace patina {
namespace {

constexpr int settleMs = 200;
const QString presetPattern = QStringLiteral("*.patina.json");

QString text(const std::filesystem::path& path) {
    return QString::fromStdString(path.string());
}

struct Folders {
    std::vector<PresetEntry> entries;
    Errors errors; ///< of the files that cannot be read
};

void readFolder(const std::filesystem::path& folder, bool shipped, const Catalog& catalog,
                Folders& read) {
    QDirIterator walk(text(folder), {presetPattern}, QDir::Files, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        const std::filesystem::path file = walk.next().toStdString();
        if (Checked<PresetReading> reading = readPreset(file, catalog)) {
            read.entries.push_back({file, std::move(reading->material), shipped});
        } else {
            const Errors& errors = reading.error();
            read.errors.insert(read.errors.end(), errors.begin(), errors.end());
        }
    }
}

Folders readAll(const Catalog& catalog) {
    Folders read;
    readFolder(PresetLibrary::shippedFolder(), true, catalog, read);
    readFolder(PresetLibrary::userFolder(), false, catalog, read);
    std::vector<PresetEntry>& entries = read.entries;
    std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
        return QString::localeAwareCompare(QString::fromStdString(a.material.name),
                                           QString::fromStdString(b.material.name)) < 0;
    });
    return read;
}

/// With the presets in them: one that is written in place changes no folder.
QStringList pathsBelow(const std::filesystem::path& top) {
    if (!QDir(text(top)).exists()) {
        return {};
    }
    QStringList paths{text(top)};
    QDirIterator walk(text(top), {presetPattern},
                      QDir::AllDirs | QDir::Files | QDir::NoDotAndDotDot,
                      QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        paths << walk.next();
    }
    return paths;
}

} // namespace

PresetLibrary::PresetLibrary(std::shared_ptr<const Catalog> catalog, QObject* parent)
    : QObject(parent), catalog_(std::move(catalog)) {
    settle_.setSingleShot(true);
    settle_.setInterval(settleMs);
    connect(&settle_, &QTimer::timeout, this, &PresetLibrary::scan);
}

void PresetLibrary::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
    settle_.start();
}

void PresetLibrary::scan() {
    std::error_code ignored; // a folder that cannot be made has no presets in it
    std::filesystem::create_directories(userFolder(), ignored);
    watchAll();
    const auto take = [this](const Result<Folders>& read) {
        if (!read) {
            Q_EMIT checked({read.error()});
            return;
        }
        isRead_ = true;
        if (read->entries != entries_) {
            entries_ = read->entries;
            Q_EMIT changed();
        }
        Q_EMIT checked(read->errors);
    };
    worker_.ask([catalog = catalog_](Worker::Control&) { return readAll(*catalog); }, take,
                QStringLiteral("folders"));
}

std::filesystem::path PresetLibrary::shippedFolder() {
    return dataFolder() / "presets";
}

std::filesystem::path PresetLibrary::userFolder() {
    return userDataFolder() / "presets";
}

/// Anew each time: a folder that was moved away and made again is another one.
void PresetLibrary::watchAll() {
    watcher_ = std::make_unique<QFileSystemWatcher>();
    const auto settle = [this] { settle_.start(); };
    connect(watcher_.get(), &QFileSystemWatcher::directoryChanged, this, settle);
    connect(watcher_.get(), &QFileSystemWatcher::fileChanged, this, settle);
    QStringList wanted = pathsBelow(shippedFolder()) + pathsBelow(userFolder());
    wanted << text(userDataFolder());
    wanted.removeIf([](const QString& path) { return !QFileInfo::exists(path); });
    if (!wanted.isEmpty()) {
        watcher_->addPaths(wanted);
    }
}

} // namespace patina
