// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.h"

#include <algorithm>

#include <QDir>
#include <QFileInfo>

#include "core/ordinary_file.h"

namespace patina {
namespace {

constexpr int maxRecentFiles = 12;
constexpr int maxEnvironments = 24;
constexpr int maxAskedFiles = 200;
constexpr std::uintmax_t maxSettingsBytes = 16u << 20;

std::filesystem::path xdgFolder(const char* variable, const char* fallback) {
    const QString set = qEnvironmentVariable(variable);
    const QString base = QDir::isAbsolutePath(set) ? set : QDir::home().filePath(fallback);
    return std::filesystem::path(base.toStdString()) / "patina";
}

/// Returns where what is remembered lies. In place of what is there and is no ordinary file comes a
/// name that no file can have: nothing is then remembered longer than the program runs.
QString settingsFile() {
    const std::filesystem::path file = configFolder() / "patina.ini";
    std::error_code ignored; // it is refused then
    const bool isUsable =
        std::filesystem::status(file, ignored).type() == std::filesystem::file_type::not_found ||
        OrdinaryFile::open(file, maxSettingsBytes);
    return QString::fromStdString(isUsable ? file.string() : "/dev/null/patina.ini");
}

constexpr const char* recentFilesKey = "files/recent";
constexpr const char* environmentsKey = "files/environments";

QStringList existingFiles(const QSettings& settings, const char* key) {
    QStringList files = settings.value(key).toStringList();
    files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
    return files;
}

/// Returns the list with the newest first, at most so many.
QStringList withNewest(QStringList files, const QString& newest, int maxFiles) {
    files.removeAll(newest);
    files.prepend(newest);
    return files.mid(0, maxFiles);
}

void addFile(QSettings& settings, const char* key, const QString& file, int maxFiles) {
    const QStringList files = settings.value(key).toStringList();
    settings.setValue(key, withNewest(files, QFileInfo(file).absoluteFilePath(), maxFiles));
}

/// A path has characters that are none for a key.
QString outsideKey(const QString& file, bool allowed) {
    const QByteArray name = file.toUtf8().toBase64(QByteArray::Base64UrlEncoding);
    return QStringLiteral("outside/%1/%2")
        .arg(allowed ? QStringLiteral("allowed") : QStringLiteral("refused"),
             QString::fromLatin1(name));
}

QString presetsKey(Session::Presets which) {
    switch (which) {
    case Session::Presets::Favourites:
        return QStringLiteral("presets/favourites");
    case Session::Presets::Recent:
        return QStringLiteral("presets/recent");
    default:
        return QStringLiteral("presets/folders");
    }
}

} // namespace

Session::Session() : settings_(settingsFile(), QSettings::IniFormat) {}

QByteArray Session::windowGeometry() const {
    return settings_.value("window/geometry").toByteArray();
}

QByteArray Session::windowLayout() const {
    return settings_.value("window/layout").toByteArray();
}

QStringList Session::openedDocks() const {
    return settings_.value("window/openedDocks").toStringList();
}

void Session::setOpenedDocks(const QStringList& names) {
    settings_.setValue("window/openedDocks", names);
}

void Session::setWindow(const QByteArray& geometry, const QByteArray& layout) {
    settings_.setValue("window/geometry", geometry);
    settings_.setValue("window/layout", layout);
}

QStringList Session::recentFiles() const {
    return existingFiles(settings_, recentFilesKey);
}

void Session::addRecentFile(const QString& file) {
    addFile(settings_, recentFilesKey, file, maxRecentFiles);
}

void Session::clearRecentFiles() {
    settings_.remove(recentFilesKey);
}

QStringList Session::environments() const {
    return existingFiles(settings_, environmentsKey);
}

void Session::addEnvironment(const QString& file) {
    addFile(settings_, environmentsKey, file, maxEnvironments);
}

QStringList Session::outside(const QString& file, bool allowed) const {
    return settings_.value(outsideKey(file, allowed)).toStringList();
}

void Session::addOutside(const QString& file, bool allowed, const QStringList& others) {
    const auto put = [&](bool where, const QStringList& files) {
        const QString key = outsideKey(file, where);
        files.isEmpty() ? settings_.remove(key) : settings_.setValue(key, files);
    };
    QStringList same = outside(file, allowed);
    QStringList opposite = outside(file, !allowed);
    for (const QString& other : others) {
        same.removeAll(other);
        opposite.removeAll(other);
    }
    put(allowed, same + others);
    put(!allowed, opposite);
    QStringList asked = settings_.value("outside/files").toStringList();
    asked.removeAll(file);
    asked.prepend(file);
    for (const QString& old : asked.mid(maxAskedFiles)) {
        settings_.remove(outsideKey(old, true));
        settings_.remove(outsideKey(old, false));
    }
    settings_.setValue("outside/files", QStringList(asked.mid(0, maxAskedFiles)));
}

Look Session::look() const {
    const QString look = settings_.value("view/look").toString();
    if (look == "dark") {
        return Look::Dark;
    }
    return look == "light" ? Look::Light : Look::System;
}

void Session::setLook(Look look) {
    settings_.setValue("view/look", look == Look::Dark    ? "dark"
                                    : look == Look::Light ? "light"
                                                          : "system");
}

MouseHabits Session::mouseHabits() const {
    const std::string id = settings_.value("view/mouse").toString().toStdString();
    const auto found = std::ranges::find(mouseSchemeIds, id);
    const auto place = found == mouseSchemeIds.end() ? 0 : found - mouseSchemeIds.begin();
    return {static_cast<MouseScheme>(place), settings_.value("view/wheelZooms", true).toBool()};
}

void Session::setMouseHabits(const MouseHabits& habits) {
    const std::string_view id = mouseSchemeIds.at(static_cast<std::size_t>(habits.scheme));
    settings_.setValue("view/mouse", QString::fromUtf8(id.data(), qsizetype(id.size())));
    settings_.setValue("view/wheelZooms", habits.wheelZooms);
}

std::optional<QString> Session::keysOf(const QString& command) const {
    const QVariant keys = settings_.value("keys/" + command);
    return keys.isValid() ? std::optional(keys.toString()) : std::nullopt;
}

void Session::setKeysOf(const QString& command, const std::optional<QString>& keys) {
    const QString key = "keys/" + command;
    keys ? settings_.setValue(key, *keys) : settings_.remove(key);
}

bool Session::showsLights() const {
    return settings_.value("view/lights", true).toBool();
}

void Session::setShowsLights(bool shows) {
    settings_.setValue("view/lights", shows);
}

CompareLook Session::compareLook() const {
    const CompareLook usual;
    const auto number = [this](const char* key, double usually, double min, double max) {
        const double value = settings_.value(key, usually).toDouble();
        return value >= min && value <= max ? value : usually;
    };
    const CompareModeRow& blink = rowOf(CompareMode::Blink);
    return {compareModeCalled(settings_.value("compare/mode").toString()),
            number("compare/wipe", usual.wipe, 0.0, 1.0),
            number("compare/wipeAngle", usual.wipeAngle, -180.0, 180.0),
            number("compare/onion", usual.onion, 0.0, 1.0),
            number("compare/blink", usual.blink, blink.min, blink.max),
            static_cast<ViewArrangement>(static_cast<int>(
                number("compare/arrangement", 0.0, 0.0, int(ViewArrangement::Column))))};
}

void Session::setCompareLook(const CompareLook& look) {
    settings_.setValue("compare/mode", rowOf(look.mode).id);
    settings_.setValue("compare/wipe", look.wipe);
    settings_.setValue("compare/wipeAngle", look.wipeAngle);
    settings_.setValue("compare/onion", look.onion);
    settings_.setValue("compare/blink", look.blink);
    settings_.setValue("compare/arrangement", static_cast<int>(look.arrangement));
}

bool Session::keepsParked() const {
    return settings_.value("files/keepParked", false).toBool();
}

void Session::setKeepsParked(bool keeps) {
    settings_.setValue("files/keepParked", keeps);
}

MeshImport Session::meshImport() const {
    const MeshImport usual;
    const double scale = settings_.value("import/scale", usual.scale).toDouble();
    return {settings_.value("import/fits", usual.fits).toBool(), scale > 0.0 ? scale : usual.scale,
            settings_.value("import/flips", usual.flips).toBool(),
            settings_.value("import/zUp", usual.isZUp).toBool(),
            settings_.value("import/joins", usual.joins).toBool()};
}

void Session::setMeshImport(const MeshImport& import) {
    settings_.setValue("import/fits", import.fits);
    settings_.setValue("import/scale", import.scale);
    settings_.setValue("import/flips", import.flips);
    settings_.setValue("import/zUp", import.isZUp);
    settings_.setValue("import/joins", import.joins);
}

QStringList Session::presets(Presets which) const {
    return settings_.value(presetsKey(which)).toStringList();
}

void Session::setPresets(Presets which, const QStringList& paths) {
    settings_.setValue(presetsKey(which), paths);
}

Session::PresetsLook Session::presetsLook() const {
    return {settings_.value("presets/pictureSize", 0).toInt(),
            settings_.value("presets/asList", false).toBool(),
            settings_.value("presets/order").toString()};
}

void Session::setPresetsLook(const PresetsLook& look) {
    settings_.setValue("presets/pictureSize", look.pictureSize);
    settings_.setValue("presets/asList", look.asList);
    settings_.setValue("presets/order", look.order);
}

QString Session::folder(const QString& purpose) const {
    const QString folder = settings_.value("folders/" + purpose).toString();
    return QDir(folder).exists() && !folder.isEmpty() ? folder : QDir::homePath();
}

void Session::setFolderOf(const QString& purpose, const QString& file) {
    settings_.setValue("folders/" + purpose, QFileInfo(file).absolutePath());
}

std::filesystem::path configFolder() {
    return xdgFolder("XDG_CONFIG_HOME", ".config");
}

std::filesystem::path cacheFolder() {
    return xdgFolder("XDG_CACHE_HOME", ".cache");
}

std::filesystem::path stateFolder() {
    return xdgFolder("XDG_STATE_HOME", ".local/state");
}

std::filesystem::path userDataFolder() {
    return xdgFolder("XDG_DATA_HOME", ".local/share");
}

std::filesystem::path programFolder() {
    return cacheFolder() / "programs";
}

} // namespace patina
