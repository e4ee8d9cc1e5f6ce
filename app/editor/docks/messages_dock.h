// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "docks/dock_context.h"

class QPlainTextEdit;

namespace patina {

/// Shows every message as "file:line:column: text", which can be selected and copied.
class MessagesDock : public QWidget {
    Q_OBJECT

  public:
    explicit MessagesDock(const DockContext& context);

  private:
    void update();

    MessageLog& messages_;
    QPlainTextEdit* text_;
};

} // namespace patina
