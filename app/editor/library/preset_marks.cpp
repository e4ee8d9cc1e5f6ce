// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/preset_marks.h"

#include "session/session.h"

namespace patina {
namespace {

constexpr int maxRecent = 40;

} // namespace

PresetMarks::PresetMarks(Session& session, QObject* parent)
    : QObject(parent), session_(session), recent_(session.presets(Session::Presets::Recent)) {
    const QStringList favourites = session.presets(Session::Presets::Favourites);
    favourites_ = {favourites.begin(), favourites.end()};
}

void PresetMarks::setFavourites(const QStringList& files, bool on) {
    for (const QString& file : files) {
        if (on) {
            favourites_.insert(file);
        } else {
            favourites_.remove(file);
        }
    }
    QStringList sorted = favourites_.values();
    sorted.sort();
    session_.setPresets(Session::Presets::Favourites, sorted);
    Q_EMIT changed();
}

void PresetMarks::noteUsed(const QString& file) {
    recent_.removeAll(file);
    recent_.prepend(file);
    recent_ = recent_.mid(0, maxRecent);
    session_.setPresets(Session::Presets::Recent, recent_);
    Q_EMIT changed();
}

} // namespace patina
