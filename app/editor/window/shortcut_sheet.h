// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "session/mouse_scheme.h"

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace patina {

class CommandKeys;
struct Command;

/// Lists what every key and every drag does, filters the list by words, and gives commands other
/// keys.
class ShortcutSheet : public QDialog {
    Q_OBJECT

  public:
    /// The habits say which drags move a camera.
    ShortcutSheet(CommandKeys& keys, const MouseHabits& habits, QWidget* parent);

  private:
    void makeLayout();
    void fill();
    void search(const QString& words);
    void followRow();
    void followKeys();
    void set();
    const Command* current() const;

    CommandKeys& keys_;
    MouseHabits habits_;
    QLineEdit* search_;
    QTreeWidget* list_;
    QKeySequenceEdit* edit_;
    QPushButton* set_;
    QPushButton* reset_;
    QLabel* conflict_;
};

} // namespace patina
