// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include <QObject>
#include <QString>

#include "core/error.h"

namespace patina {

/// Keeps what went wrong so far, and notes on what did not. Events stay until they are cleared;
/// what a group (the catalogue, a view) has to say is replaced whenever it changes, and gone when
/// it is well again.
class MessageLog : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// Returns all messages: the groups first, then the events, oldest first.
    Errors messages() const;
    int count() const;
    /// Returns how many of them are notes.
    int noteCount() const;

    void add(const Error& event);
    /// Adds an event that nobody has to do anything about.
    void addNote(const Error& event);
    void setGroup(const QString& group, const Errors& messages);
    void clearEvents();

  Q_SIGNALS:
    void changed();
    /// Something new went wrong, as opposed to a note and to something going away.
    void arrived(patina::Error message);

  private:
    struct Event {
        Error message;
        bool isNote = false;
    };

    void append(const Event& event);

    std::map<QString, Errors> groups_;
    std::vector<Event> events_;
};

} // namespace patina
