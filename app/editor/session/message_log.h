// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include <QObject>
#include <QString>

#include "core/error.h"

namespace patina {

/// What went wrong so far. Events stay until they are cleared; what a group (the catalogue, a
/// view) has to say is replaced whenever it changes, and gone when it is well again.
class MessageLog : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// All messages: the groups first, then the events, oldest first.
    Errors messages() const;
    int count() const;

    void add(const Error& event);
    void setGroup(const QString& group, const Errors& messages);
    void clearEvents();

  Q_SIGNALS:
    void changed();
    /// Something new came, as opposed to something going away.
    void arrived(patina::Error message);

  private:
    std::map<QString, Errors> groups_;
    Errors events_;
};

} // namespace patina
