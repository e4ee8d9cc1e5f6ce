// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSet>
#include <QStringList>

namespace patina {

class Session;

/// Knows which preset files are favourites and which were used last, and keeps both in the session.
class PresetMarks : public QObject {
    Q_OBJECT

  public:
    explicit PresetMarks(Session& session, QObject* parent = nullptr);

    bool isFavourite(const QString& file) const { return favourites_.contains(file); }
    void setFavourites(const QStringList& files, bool on);

    const QStringList& recent() const { return recent_; } ///< has the newest first
    void noteUsed(const QString& file);

  Q_SIGNALS:
    void changed();

  private:
    Session& session_;
    QSet<QString> favourites_;
    QStringList recent_;
};

} // namespace patina
