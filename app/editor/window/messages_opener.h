// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace patina {

class MessageLog;
class WindowLayout;

/// Brings the messages to the front when something goes wrong. Where they were hidden before they
/// go again when nothing is left of them, unless the user has hidden or shown them meanwhile.
class MessagesOpener : public QObject {
    Q_OBJECT

  public:
    /// Both outlive it.
    MessagesOpener(const MessageLog& messages, const WindowLayout& layout, QObject* parent);

  private:
    void open();
    void closeSpent();

    const MessageLog& messages_;
    const WindowLayout& layout_;
    bool hasOpened_ = false; ///< it has shown the dock
};

} // namespace patina
