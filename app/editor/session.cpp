// SPDX-License-Identifier: GPL-3.0-or-later
#include "session.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace patina {
namespace {

constexpr int mostRecentFiles = 12;

std::filesystem::path xdgFolder(const char* variable, const char* fallback) {
    const QString set = qEnvironmentVariable(variable);
    const QString base = QDir::isAbsolutePath(set) ? set : QDir::home().filePath(fallback);
    return std::filesystem::path(base.toStdString()) / "patina";
}

} // namespace

Session::Session() : settings_(QSettings::IniFormat, QSettings::UserScope, "patina", "patina") {}

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
    QStringList files = settings_.value("files/recent").toStringList();
    files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
    return files;
}

void Session::addRecentFile(const QString& file) {
    QStringList files = settings_.value("files/recent").toStringList();
    const QString absolute = QFileInfo(file).absoluteFilePath();
    files.removeAll(absolute);
    files.prepend(absolute);
    settings_.setValue("files/recent", QStringList(files.mid(0, mostRecentFiles)));
}

void Session::clearRecentFiles() {
    settings_.remove("files/recent");
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

QString Session::folder(const QString& purpose) const {
    const QString folder = settings_.value("folders/" + purpose).toString();
    return QDir(folder).exists() && !folder.isEmpty() ? folder : QDir::homePath();
}

void Session::setFolderOf(const QString& purpose, const QString& file) {
    settings_.setValue("folders/" + purpose, QFileInfo(file).absolutePath());
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

} // namespace patina
