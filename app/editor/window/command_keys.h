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

/// Something that a menu offers.
struct Command {
    QString id;   ///< the way to it through the menus, "File/Save"
    QString name; ///< as it is called there
    QAction* action = nullptr;
    QList<QKeySequence> usual; ///< its keys until the user gives it others
};

/// Knows every command of the menus and the keys that it has, the user's own among them.
class CommandKeys : public QObject {
    Q_OBJECT

  public:
    /// The menus are complete by then. What is filled while a menu opens is no command.
    CommandKeys(QMenuBar& bar, Session& session, QObject* parent);

    const std::vector<Command>& commands() const { return commands_; }

    /// The other command that has these keys; null: none has.
    const Command* holderOf(const QKeySequence& keys, const Command& but) const;

    /// Gives a command these keys, and takes them from the one that had them. Empty: it has none.
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

/// The text of an action without the marks of a menu.
QString plainName(const QString& text);

} // namespace patina
