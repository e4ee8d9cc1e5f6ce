// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <QKeySequence>
#include <QObject>

class QAction;
class QMenu;
class QMenuBar;

namespace patina {

class Session;

/// Describes an action that a menu offers.
struct Command {
    QString id;   ///< is its path through the menus, as in "File/Save"; names it in the session
    QString name; ///< is its text in the menu, without "&" and "…"
    QAction* action = nullptr;
    QList<QKeySequence> usual; ///< are its keys until the user gives it others
};

/// Knows every command of the menus and the keys that it has, the user's own among them.
class CommandKeys : public QObject {
    Q_OBJECT

  public:
    /// Collects the commands of the menus, which have to be complete. Actions that are added while
    /// a menu opens are not commands.
    CommandKeys(QMenuBar& bar, Session& session, QObject* parent);

    const std::vector<Command>& commands() const { return commands_; }

    /// Returns the command other than `but` that has these keys; null where none has.
    const Command* holderOf(const QKeySequence& keys, const Command& but) const;

    /// Gives a command these keys, and takes them from the one that had them. Empty keys leave it
    /// with none. The session stores this.
    void setKeys(const Command& command, const QKeySequence& keys);
    /// Gives a command its usual keys, in the same way.
    void reset(const Command& command);
    bool isChanged(const Command& command) const;

  Q_SIGNALS:
    void changed();

  private:
    void collect(const QMenu& menu, const QString& path);
    void apply(const Command& command);
    void takeFromOthers(const QKeySequence& keys, const Command& command);
    void store(const Command& command, const std::optional<QString>& keys);

    Session& session_;
    std::vector<Command> commands_;
};

/// Returns the text of an action without the "&" and "…" of a menu.
QString plainName(const QString& text);

} // namespace patina
