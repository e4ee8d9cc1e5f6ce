// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/autosave.h"

#include <algorithm>
#include <map>
#include <utility>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLockFile>

#include "core/atomic_file.h"
#include "core/ordinary_file.h"
#include "material/file_suffixes.h"
#include "scene/scene_file.h"
#include "text/as_text.h"

namespace patina {
namespace {

constexpr int defaultQuietMs = 100;
constexpr int defaultLongestMs = 200;
constexpr std::uintmax_t maxOriginBytes = 64u << 10;

std::filesystem::path withEnding(const std::filesystem::path& stem, std::string_view ending) {
    return stem.string() + std::string(ending);
}

std::filesystem::path sceneOf(const std::filesystem::path& stem) {
    return withEnding(stem, sceneSuffix);
}

std::filesystem::path originOf(const std::filesystem::path& stem) {
    return withEnding(stem, ".origin");
}

QString lockOf(const std::filesystem::path& stem) {
    return QString::fromStdString(withEnding(stem, ".lock").string());
}

std::filesystem::path stemOf(const std::filesystem::path& scene) {
    return scene.string().substr(0, scene.string().size() - sceneSuffix.size());
}

/// Returns whether no program holds the lock, as one that still runs does.
bool isAbandoned(const std::filesystem::path& stem) {
    QLockFile lock(lockOf(stem));
    lock.setStaleLockTime(0);
    return lock.tryLock(0);
}

/// Maps the first line of an origin file to the kind of file; the second line is its path.
const std::map<QString, DocumentFile> kinds{
    {"none", {DocumentFile::Kind::None, {}, false}},
    {"preset", {DocumentFile::Kind::Preset, {}, false}},
    {"read-only preset", {DocumentFile::Kind::Preset, {}, true}},
    {"scene", {DocumentFile::Kind::Scene, {}, false}},
    {"read-only scene", {DocumentFile::Kind::Scene, {}, true}}};

std::string textOf(const DocumentFile& file) {
    for (const auto& [name, kind] : kinds) {
        if (kind.kind == file.kind && kind.readOnly == file.readOnly) {
            return name.toStdString() + '\n' + file.path.string();
        }
    }
    return {};
}

DocumentFile readOrigin(const std::filesystem::path& path) {
    const Result<std::string> content = readFile(path, maxOriginBytes);
    if (!content) {
        return {};
    }
    const QString text = QString::fromStdString(*content);
    const auto kind = kinds.find(text.section('\n', 0, 0));
    if (kind == kinds.end()) {
        return {};
    }
    DocumentFile origin = kind->second;
    origin.path = text.section('\n', 1).toStdString();
    return origin;
}

/// Writes a small file unless it has that content already.
Result<void> writeOnce(const std::filesystem::path& path, const std::string& text) {
    const Result<std::string> before = readFile(path, maxOriginBytes);
    return before && *before == text ? Result<void>() : writeFileAtomically(path, text);
}

/// Returns when the work was last written: with the copy, or with an edit in its journal.
QDateTime lastWritten(const QFileInfo& scene) {
    const QFileInfo journal(
        QString::fromStdString(EditJournal::beside(scene.filePath().toStdString()).string()));
    return journal.exists() ? std::max(scene.lastModified(), journal.lastModified())
                            : scene.lastModified();
}

} // namespace

Autosave::Autosave(Document& document, DocumentFiles& files, std::filesystem::path folder,
                   QObject* parent)
    : QObject(parent), document_(document), files_(files), folder_(std::move(folder)) {
    quiet_.setSingleShot(true);
    longest_.setSingleShot(true);
    setIntervals(defaultQuietMs, defaultLongestMs);
    connect(&quiet_, &QTimer::timeout, this, &Autosave::save);
    connect(&longest_, &QTimer::timeout, this, &Autosave::save);
    onChange(document, DocumentChange::Drawn | DocumentChange::Bookmarks, this,
             &Autosave::schedule);
    // The first edit is announced before the document counts as modified.
    connect(&document, &Document::modifiedChanged, this, &Autosave::schedule);
}

Autosave::~Autosave() = default;

void Autosave::setIntervals(int quietMs, int longestMs) {
    quiet_.setInterval(quietMs);
    longest_.setInterval(longestMs);
}

void Autosave::complete(const Recovery& recovery) {
    if (const Result<void> joined = EditJournal::join(recovery.scene); !joined) {
        Q_EMIT failed(joined.error());
    }
}

void Autosave::adopt(const Recovery& recovery) {
    if (takeStem()) {
        isAdopted_ = true;
        std::error_code ignored; // it stays where it is and is offered again
        std::filesystem::rename(recovery.scene, sceneOf(stem_), ignored);
        std::filesystem::rename(originOf(stemOf(recovery.scene)), originOf(stem_), ignored);
    }
}

void Autosave::discard() {
    stop();
    isAdopted_ = false;
    if (lock_) {
        remove({sceneOf(stem_), {}, {}});
        lock_.reset();
    }
}

void Autosave::giveUpOwn() {
    if (!isAdopted_ && lock_) {
        discard();
    }
}

void Autosave::giveUp() {
    stop();
    giveUpOwn();
    if (std::exchange(isAdopted_, false)) {
        lock_.reset(); // leaves the copy to be found again
    }
}

void Autosave::stop() {
    quiet_.stop();
    longest_.stop();
    worker_.finish();
}

/// Starts the timers; removes the copy if an undo went back to the saved state.
void Autosave::schedule() {
    if (!document_.isModified()) {
        giveUpOwn();
        return;
    }
    quiet_.start();
    if (!longest_.isActive()) {
        longest_.start();
    }
}

void Autosave::save() {
    quiet_.stop();
    longest_.stop();
    if (!document_.isModified()) {
        return;
    }
    if (!takeStem()) {
        noteEnd(
            tl::unexpected(Error{folder_.string(), 0, 0, "unsaved work cannot be kept safe here",
                                 "a folder that can be written to"}));
        return;
    }
    const auto write = [this, scene = files_.sceneToRecover(),
                        file = files_.file()](Worker::Control&) -> Result<void> {
        const Result<void> origin = writeOnce(originOf(stem_), textOf(file));
        return origin ? journal_->write(scene) : origin;
    };
    worker_.ask(
        write, [this](const Result<void>& written) { noteEnd(written); }, QStringLiteral("copy"));
}

/// Emits failed() once, and again only after a copy could be written.
void Autosave::noteEnd(const Result<void>& written) {
    if (!written && !hasFailed_) {
        Q_EMIT failed(written.error());
    }
    hasFailed_ = !written;
}

/// Chooses a unique name for this program's copy and locks it while the program runs. Returns false
/// if the folder cannot be written to.
bool Autosave::takeStem() {
    if (lock_) {
        return true;
    }
    const QString name = QStringLiteral("%1-%2")
                             .arg(QDateTime::currentMSecsSinceEpoch())
                             .arg(QCoreApplication::applicationPid());
    stem_ = folder_ / name.toStdString();
    auto lock = std::make_unique<QLockFile>(lockOf(stem_));
    lock->setStaleLockTime(0);
    if (!QDir().mkpath(QString::fromStdString(folder_.string())) || !lock->tryLock(0)) {
        return false;
    }
    lock_ = std::move(lock);
    journal_ = std::make_unique<EditJournal>(sceneOf(stem_));
    return true;
}

std::vector<Recovery> Autosave::found(const std::filesystem::path& folder) {
    std::vector<Recovery> recoveries;
    const QDir dir(QString::fromStdString(folder.string()));
    for (const QFileInfo& file :
         dir.entryInfoList({"*" + asText(sceneSuffix)}, QDir::Files, QDir::Time)) {
        const std::filesystem::path scene = file.absoluteFilePath().toStdString();
        if (isAbandoned(stemOf(scene))) {
            recoveries.push_back({scene, readOrigin(originOf(stemOf(scene))), lastWritten(file)});
        }
    }
    return recoveries;
}

void Autosave::remove(const Recovery& recovery) {
    std::error_code ignored; // it is gone already
    std::filesystem::remove(recovery.scene, ignored);
    std::filesystem::remove(EditJournal::beside(recovery.scene), ignored);
    std::filesystem::remove(originOf(stemOf(recovery.scene)), ignored);
}

} // namespace patina
