// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace patina {

class CommandKeys;

/// Runs any command of the menus by its name, or opens a panel by what it has: typed words narrow
/// the list, and Enter runs the first match or the one that the arrow keys choose.
class CommandPalette : public QDialog {
    Q_OBJECT

  public:
    CommandPalette(const CommandKeys& keys, QWidget* parent);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void fill(const QString& words);
    void run(const QListWidgetItem* item);

    const CommandKeys& keys_;
    QLineEdit* search_;
    QListWidget* list_;
    QLabel* none_; ///< says that nothing matches
};

/// Tells whether a text has all words of another one in it, in any order and case.
bool hasAllWords(const QString& text, const QString& words);

} // namespace patina
