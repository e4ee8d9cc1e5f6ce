// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/catalog_watcher.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <QDir>

namespace patina {
namespace {

/// Is long enough for an editor to write, rename and set attributes, and far below a second, within
/// which a change has to be visible.
constexpr qint64 settleMs = 120;

/// Is how long after the first change files are read even if they keep changing.
constexpr qint64 patienceMs = 400;

/// Returns whether an error names the block's descriptor or a folder that holds it.
bool hasMistake(const Catalog& catalog, const Block& block) {
    return std::any_of(catalog.errors.begin(), catalog.errors.end(), [&](const Error& error) {
        const std::string file = block.descriptorFile.string();
        return !error.file.empty() && file.starts_with(error.file) &&
               (file.size() == error.file.size() || file[error.file.size()] == '/');
    });
}

/// Returns the nearest folder above that exists, where a missing one would appear.
QString nearestFolderAbove(const std::filesystem::path& folder) {
    std::filesystem::path above = std::filesystem::absolute(folder);
    do {
        above = above.parent_path();
    } while (!QDir(QString::fromStdString(above.string())).exists());
    return QString::fromStdString(above.string());
}

} // namespace

CatalogWatcher::CatalogWatcher(std::shared_ptr<const Catalog> catalog, QObject* parent)
    : QObject(parent), catalog_(std::move(catalog)), known_(statesNow()) {
    settle_.setSingleShot(true);
    connect(&settle_, &QTimer::timeout, this, &CatalogWatcher::read);
}

void CatalogWatcher::start() {
    for (const BlockRoot& root : catalog_->roots) {
        if (!root.shipped) {
            std::error_code ignored; // a folder that cannot be made is one that cannot be watched
            std::filesystem::create_directories(root.folder, ignored);
        }
    }
    if (watchAll()) {
        settle();
    }
}

/// Waits for the last of several changes, up to `patienceMs` after the first one.
void CatalogWatcher::settle() {
    if (!settle_.isActive()) {
        sinceFirst_.start();
    }
    const qint64 left = patienceMs - sinceFirst_.elapsed();
    settle_.start(static_cast<int>(std::clamp<qint64>(left, 0, settleMs)));
}

PathStates CatalogWatcher::statesNow() const {
    PathStates states;
    for (const BlockRoot& root : catalog_->roots) {
        addPathStates(root.folder, states);
    }
    return states;
}

/// Watches all files and folders anew: a folder is watched by its inode, and one that was replaced
/// has another. Returns whether something changed since it was read.
bool CatalogWatcher::watchAll() {
    watcher_ = std::make_unique<QFileSystemWatcher>();
    connect(watcher_.get(), &QFileSystemWatcher::fileChanged, this, &CatalogWatcher::settle);
    connect(watcher_.get(), &QFileSystemWatcher::directoryChanged, this, &CatalogWatcher::settle);
    watched_ = statesNow();
    QStringList wanted;
    for (const PathState& state : watched_) {
        wanted << QString::fromStdString(state.path);
    }
    for (const BlockRoot& root : catalog_->roots) {
        wanted << nearestFolderAbove(root.folder);
    }
    wanted.removeDuplicates();
    watcher_->addPaths(wanted);
    return watched_ != known_ || statesNow() != watched_; // changed while unwatched
}

/// Reads nothing if no part of a block changed, since other files are reported, too.
void CatalogWatcher::read() {
    if (!watchAll()) {
        return;
    }
    known_ = watched_; // first, so that a change while reading leads to another reading
    Catalog read = loadCatalog(catalog_->roots);
    catalog_ = std::make_shared<const Catalog>(withLastGoodBlocks(std::move(read), *catalog_));
    if (statesNow() != known_) {
        settle();
    }
    Q_EMIT changed(catalog_);
}

Catalog withLastGoodBlocks(Catalog read, const Catalog& before) {
    for (const Block& block : before.blocks) {
        if (!read.find(block.kind, block.id) && hasMistake(read, block)) {
            read.blocks.push_back(block);
        }
    }
    std::sort(read.blocks.begin(), read.blocks.end(), [](const Block& a, const Block& b) {
        return std::tie(a.kind, a.id) < std::tie(b.kind, b.id);
    });
    return read;
}

} // namespace patina
