// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/command_keys.h"

#include <algorithm>

#include <QAction>
#include <QMenu>
#include <QMenuBar>

#include "session/session.h"

namespace patina {

CommandKeys::CommandKeys(QMenuBar& bar, Session& session, QObject* parent)
    : QObject(parent), session_(session) {
    for (const QAction* top : bar.actions()) {
        if (const QMenu* menu = top->menu()) {
            collect(*menu, plainName(top->text()));
        }
    }
    for (const Command& command : commands_) {
        apply(command);
    }
}

void CommandKeys::collect(const QMenu& menu, const QString& path) {
    for (QAction* action : menu.actions()) {
        const QString name = plainName(action->text());
        if (const QMenu* inside = action->menu()) {
            collect(*inside, path + '/' + name);
        } else if (!action->isSeparator() && !name.isEmpty()) {
            commands_.push_back({path + '/' + name, name, action, action->shortcuts()});
        }
    }
}

const Command* CommandKeys::holderOf(const QKeySequence& keys, const Command& but) const {
    const auto found = std::ranges::find_if(commands_, [&](const Command& each) {
        return each.id != but.id && !keys.isEmpty() && each.action->shortcuts().contains(keys);
    });
    return found == commands_.end() ? nullptr : &*found;
}

/// No two commands have the same keys: with both neither would be called.
void CommandKeys::takeFromOthers(const QKeySequence& keys, const Command& command) {
    if (const Command* holder = holderOf(keys, command)) {
        QList<QKeySequence> rest = holder->action->shortcuts();
        rest.removeAll(keys);
        store(*holder, QKeySequence::listToString(rest, QKeySequence::PortableText));
    }
}

void CommandKeys::setKeys(const Command& command, const QKeySequence& keys) {
    takeFromOthers(keys, command);
    store(command, keys.toString(QKeySequence::PortableText));
    Q_EMIT changed();
}

void CommandKeys::reset(const Command& command) {
    for (const QKeySequence& keys : command.usual) {
        takeFromOthers(keys, command);
    }
    store(command, std::nullopt);
    Q_EMIT changed();
}

bool CommandKeys::isChanged(const Command& command) const {
    return session_.keysOf(command.id).has_value();
}

void CommandKeys::store(const Command& command, const std::optional<QString>& keys) {
    session_.setKeysOf(command.id, keys);
    apply(command);
}

void CommandKeys::apply(const Command& command) {
    const auto own = session_.keysOf(command.id);
    command.action->setShortcuts(
        own ? QKeySequence::listFromString(*own, QKeySequence::PortableText) : command.usual);
}

QString plainName(const QString& text) {
    QString name = text;
    name.replace(QLatin1String("&&"), QString(QChar(0)));
    name.remove('&').replace(QChar(0), '&');
    name.remove(QChar(0x2026)); // …
    return name.trimmed();
}

} // namespace patina
