// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/messages_opener.h"

#include <QAction>
#include <QDockWidget>

#include "session/message_log.h"
#include "window/window_layout.h"

namespace patina {

MessagesOpener::MessagesOpener(const MessageLog& messages, const WindowLayout& layout,
                               QObject* parent)
    : QObject(parent), messages_(messages), layout_(layout) {
    connect(&messages, &MessageLog::arrived, this, &MessagesOpener::open);
    connect(&messages, &MessageLog::changed, this, &MessagesOpener::closeSpent);
    const QDockWidget* dock = layout.dock("messages");
    connect(dock->toggleViewAction(), &QAction::triggered, this, [this] { hasOpened_ = false; });
    connect(dock, &QDockWidget::visibilityChanged, this,
            [this, dock] { hasOpened_ = hasOpened_ && !dock->isHidden(); });
}

void MessagesOpener::open() {
    const bool wasHidden = layout_.dock("messages")->isHidden();
    layout_.bringToFront("messages");
    hasOpened_ = hasOpened_ || wasHidden;
}

void MessagesOpener::closeSpent() {
    if (hasOpened_ && messages_.count() == 0) {
        layout_.dock("messages")->hide();
    }
}

} // namespace patina
