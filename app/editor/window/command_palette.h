// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDialog>

#include "window/named_choices.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace patina {

class CommandKeys;

/// Runs any command of the menus by its name, opens a panel by what it has, or takes a model or a
/// preset: typed words narrow the list, and Enter runs the first match or the one that the arrow
/// keys choose.
class CommandPalette : public QDialog {
    Q_OBJECT

  public:
    CommandPalette(const CommandKeys& keys, std::vector<NamedChoice> choices, QWidget* parent);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void fill(const QString& words);
    QString textOf(std::size_t place) const;
    void run(const QListWidgetItem* item);

    const CommandKeys& keys_;
    std::vector<NamedChoice> choices_;
    QLineEdit* search_;
    QListWidget* list_;
    QLabel* none_; ///< says that nothing matches
};

/// Says where words are looked for: at the beginnings of words, or anywhere.
enum class Words { Begun, Within };

/// Tells whether a text has all words of another one in it, in any order and case.
bool hasAllWords(const QString& text, const QString& words, Words how = Words::Within);

} // namespace patina
