// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/catalog_watcher.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <QDir>

namespace patina {
namespace {

/// Long enough for an editor to write, rename and set attributes; far below the second in which
/// the change has to be seen.
constexpr qint64 settleMs = 120;

/// What never settles is read all the same, so long after the first change.
constexpr qint64 patienceMs = 400;

/// Tells whether the block's descriptor, or a folder that it lies in, is the file of a mistake.
bool hasMistake(const Catalog& catalog, const Block& block) {
    return std::any_of(catalog.errors.begin(), catalog.errors.end(), [&](const Error& error) {
        const std::string file = block.descriptorFile.string();
        return !error.file.empty() && file.starts_with(error.file) &&
               (file.size() == error.file.size() || file[error.file.size()] == '/');
    });
}

/// The folder that a missing one would come back into.
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

/// After the last change of several, but not for ever.
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

/// A folder is watched by what it is, not by its name: one that was moved away and made again has
/// to be found anew. True when something is not as it was when it was read.
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
    return watched_ != known_ || statesNow() != watched_; // which came while nobody looked
}

/// What the system tells of may be a file that nobody reads.
void CatalogWatcher::read() {
    if (!watchAll()) {
        return;
    }
    known_ = watched_; // first, so that a change while it reads is another reading
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
