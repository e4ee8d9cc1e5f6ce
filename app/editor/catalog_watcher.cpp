// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog_watcher.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <QDirIterator>

namespace patina {
namespace {

/// Long enough for an editor to write, rename and set attributes; far below the second in which
/// the change has to be seen.
constexpr int settleMs = 120;

bool hasMistake(const Catalog& catalog, const Block& block) {
    return std::any_of(catalog.errors.begin(), catalog.errors.end(), [&](const Error& error) {
        return error.file == block.descriptorFile.string();
    });
}

QStringList foldersAndFiles(const std::filesystem::path& root) {
    const QString top = QString::fromStdString(root.string());
    if (!QDir(top).exists()) {
        return {};
    }
    QStringList paths{top};
    QDirIterator walk(top, QDir::AllEntries | QDir::NoDotAndDotDot, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        paths << walk.next();
    }
    return paths;
}

/// The folder that a missing one would come back into.
QString nearestFolderAbove(std::filesystem::path folder) {
    do {
        folder = folder.parent_path();
    } while (!QDir(QString::fromStdString(folder.string())).exists());
    return QString::fromStdString(folder.string());
}

} // namespace

CatalogWatcher::CatalogWatcher(std::shared_ptr<const Catalog> catalog, QObject* parent)
    : QObject(parent), catalog_(std::move(catalog)) {
    settle_.setSingleShot(true);
    settle_.setInterval(settleMs);
    connect(&settle_, &QTimer::timeout, this, &CatalogWatcher::read);
}

void CatalogWatcher::start() {
    for (const BlockRoot& root : catalog_->roots) {
        if (!root.shipped) {
            std::error_code ignored; // a folder that cannot be made is one that cannot be watched
            std::filesystem::create_directories(root.folder, ignored);
        }
    }
    watchAll();
}

void CatalogWatcher::reload() {
    settle_.start();
}

/// A folder is watched by what it is, not by its name: one that was moved away and made again has
/// to be found anew.
void CatalogWatcher::watchAll() {
    watcher_ = std::make_unique<QFileSystemWatcher>();
    connect(watcher_.get(), &QFileSystemWatcher::fileChanged, this, &CatalogWatcher::reload);
    connect(watcher_.get(), &QFileSystemWatcher::directoryChanged, this, &CatalogWatcher::reload);
    QStringList wanted;
    for (const BlockRoot& root : catalog_->roots) {
        wanted << foldersAndFiles(root.folder);
        if (!root.shipped) {
            wanted << nearestFolderAbove(root.folder);
        }
    }
    wanted.removeDuplicates();
    watcher_->addPaths(wanted);
}

void CatalogWatcher::read() {
    if (watcher_) {
        watchAll(); // first, so that a change while it reads is another reading
    }
    Catalog read = loadCatalog(catalog_->roots);
    catalog_ = std::make_shared<const Catalog>(withLastGoodBlocks(std::move(read), *catalog_));
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
