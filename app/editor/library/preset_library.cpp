// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/preset_library.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include <QDir>

#include "session/session.h"

namespace patina {
namespace {

constexpr int settleMs = 200;

} // namespace

PresetLibrary::PresetLibrary(std::shared_ptr<const Catalog> catalog, Session& session,
                             QObject* parent)
    : QObject(parent), session_(session), catalog_(std::move(catalog)), marks_(session),
      worker_({.name = tr("Reading presets")}) {
    settle_.setSingleShot(true);
    settle_.setInterval(settleMs);
    connect(&settle_, &QTimer::timeout, this, &PresetLibrary::scan);
    connect(&watcher_, &FolderWatcher::changed, &settle_, qOverload<>(&QTimer::start));
}

void PresetLibrary::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
    isOfCatalog_ = false;
    settle_.start();
}

PresetPtr PresetLibrary::find(const QString& file) const {
    const auto found = std::ranges::find_if(
        entries_, [&file](const PresetPtr& entry) { return entry->path == file; });
    return found == entries_.end() ? nullptr : *found;
}

std::vector<PresetFolder> PresetLibrary::folders() const {
    std::vector<PresetFolder> folders{{shippedFolder(), true}, {userFolder(), false}};
    for (const QString& folder : session_.presets(Session::Presets::Folders)) {
        folders.push_back({folder.toStdString(), false});
    }
    return folders;
}

void PresetLibrary::addFolder(const QString& folder) {
    const std::string path = QDir::cleanPath(QDir(folder).absolutePath()).toStdString();
    const bool isKnown = std::ranges::any_of(folders(), [&path](const PresetFolder& known) {
        return path == known.path || path.starts_with(known.path.string() + '/');
    });
    if (!isKnown) {
        session_.setPresets(Session::Presets::Folders, session_.presets(Session::Presets::Folders)
                                                           << QString::fromStdString(path));
        scan();
    }
}

void PresetLibrary::removeFolder(const QString& folder) {
    QStringList folders = session_.presets(Session::Presets::Folders);
    if (folders.removeAll(folder) > 0) {
        session_.setPresets(Session::Presets::Folders, folders);
        scan();
    }
}

void PresetLibrary::scan() {
    std::error_code ignored; // a folder that cannot be made has no presets in it
    std::filesystem::create_directories(userFolder(), ignored);
    settle_.stop();
    watch(); // first, so that a change while reading leads to another reading
    const auto known = isOfCatalog_ ? entries_ : std::vector<PresetPtr>();
    const bool isFirst = !isRead_;
    const auto reading = [this, known, isFirst, folders = folders(),
                          catalog = catalog_](Worker::Control& control) {
        return readPresets(folders, *catalog, known, [&](const PresetsRead& soFar) {
            if (isFirst) {
                control.show([this, entries = soFar.entries] { setEntries(entries); });
            }
            return !control.isCancelled();
        });
    };
    const auto take = [this, catalog = catalog_](const Result<PresetsRead>& read) {
        if (!read) {
            Q_EMIT checked({read.error()});
            return;
        }
        isRead_ = true;
        isOfCatalog_ = catalog == catalog_;
        tellVariants(read->entries);
        setEntries(read->entries);
        if (watched_ != read->folders) {
            watched_ = read->folders;
            settle_.start();
        }
        Q_EMIT checked(read->errors);
    };
    worker_.ask(reading, take, QStringLiteral("folders"));
}

/// Compares the variants with those that were read before.
void PresetLibrary::tellVariants(const std::vector<PresetPtr>& entries) {
    std::unordered_map<std::string, PresetPtr> before;
    for (const PresetPtr& entry : entries_) {
        if (entry->sources.size() > 1) {
            before[entry->file.string()] = entry;
        }
    }
    std::vector<VariantChange> changes;
    for (const PresetPtr& entry : entries) {
        const auto found = before.find(entry->file.string());
        if (found != before.end() && found->second->sources.front() == entry->sources.front() &&
            !(found->second->material == entry->material)) {
            changes.push_back({found->second, entry});
        }
    }
    if (!changes.empty()) {
        Q_EMIT variantsChanged(changes);
    }
}

void PresetLibrary::setEntries(const std::vector<PresetPtr>& entries) {
    if (entries != entries_) {
        entries_ = entries;
        Q_EMIT changed();
    }
}

std::filesystem::path PresetLibrary::shippedFolder() {
    return dataFolder() / "presets";
}

std::filesystem::path PresetLibrary::userFolder() {
    return userDataFolder() / "presets";
}

/// Watches all folders again, since one that was replaced has another inode.
void PresetLibrary::watch() {
    std::vector<std::filesystem::path> all = watched_;
    for (const PresetFolder& folder : folders()) {
        all.push_back(folder.path);
        all.push_back(folder.path.parent_path());
    }
    watcher_.watch(all);
}

} // namespace patina
