// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "docks/dock_context.h"

class QPlainTextEdit;

namespace patina {

/// Everything that went wrong, as file:line:column: what, to be read, selected and copied.
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
