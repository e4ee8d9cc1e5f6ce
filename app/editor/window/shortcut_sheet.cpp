// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/shortcut_sheet.h"

#include <QAction>
#include <QHBoxLayout>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "window/command_keys.h"
#include "window/command_palette.h"
#include "window/help.h"

namespace patina {
namespace {

constexpr QSize sheetSize(760, 640);
constexpr int whatWidth = 470;

} // namespace

ShortcutSheet::ShortcutSheet(CommandKeys& keys, const MouseHabits& habits, QWidget* parent)
    : QDialog(parent), keys_(keys), habits_(habits), search_(new QLineEdit(this)),
      list_(new QTreeWidget(this)), edit_(new QKeySequenceEdit(this)),
      set_(new QPushButton(tr("Set"), this)), reset_(new QPushButton(tr("As Usual"), this)),
      conflict_(new QLabel(this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("shortcutSheet");
    setWindowTitle(tr("Mouse and Keys"));
    makeLayout();
    connect(search_, &QLineEdit::textChanged, this, &ShortcutSheet::search);
    connect(list_, &QTreeWidget::currentItemChanged, this, &ShortcutSheet::followRow);
    connect(edit_, &QKeySequenceEdit::keySequenceChanged, this, &ShortcutSheet::followKeys);
    connect(set_, &QPushButton::clicked, this, &ShortcutSheet::set);
    connect(reset_, &QPushButton::clicked, this, [this] {
        if (const Command* command = current()) {
            keys_.reset(*command);
        }
    });
    connect(&keys_, &CommandKeys::changed, this, &ShortcutSheet::fill);
    fill();
    resize(sheetSize);
    search_->setFocus();
}

void ShortcutSheet::makeLayout() {
    search_->setPlaceholderText(tr("Search keys and commands"));
    search_->setAccessibleName(tr("Search"));
    search_->setClearButtonEnabled(true);
    list_->setHeaderLabels({tr("What"), tr("Keys")});
    list_->setColumnWidth(0, whatWidth);
    list_->setAccessibleName(tr("Mouse and keys"));
    list_->setUniformRowHeights(true);
    edit_->setAccessibleName(tr("New keys of the chosen command"));
    set_->setAutoDefault(false);
    reset_->setAutoDefault(false);
    conflict_->setWordWrap(true);
    auto* row = new QHBoxLayout;
    row->addWidget(new QLabel(tr("Keys of the chosen command"), this));
    row->addWidget(edit_, 1);
    row->addWidget(set_);
    row->addWidget(reset_);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(search_);
    layout->addWidget(list_, 1);
    layout->addLayout(row);
    layout->addWidget(conflict_);
}

void ShortcutSheet::fill() {
    const Command* chosen = current();
    const QString before = chosen ? chosen->id : QString();
    list_->clear();
    const std::pair<QString, std::vector<KeyRow>> groups[] = {
        {tr("Mouse and keys in a view"), viewKeys(habits_)}, {tr("Values and lists"), valueKeys()}};
    for (const auto& [title, rows] : groups) {
        auto* group = new QTreeWidgetItem(list_, {title});
        for (const KeyRow& row : rows) {
            auto* item = new QTreeWidgetItem(group, {row.what, row.keys});
            item->setData(0, Qt::UserRole, -1);
        }
    }
    QTreeWidgetItem* menu = nullptr;
    const std::vector<Command>& commands = keys_.commands();
    for (std::size_t i = 0; i < commands.size(); ++i) {
        const Command& command = commands[i];
        const QString path = command.id.section('/', 0, 0);
        if (!menu || menu->text(0) != path) {
            menu = new QTreeWidgetItem(list_, {path});
        }
        const QString keys =
            QKeySequence::listToString(command.action->shortcuts(), QKeySequence::NativeText);
        auto* item = new QTreeWidgetItem(
            menu,
            {QString(command.id.section('/', 1)).replace('/', QStringLiteral(" \u203a ")), keys});
        item->setData(0, Qt::UserRole, static_cast<int>(i));
        item->setToolTip(0, command.action->whatsThis());
        QFont font = item->font(1);
        font.setBold(keys_.isChanged(command));
        item->setFont(1, font);
        if (command.id == before) {
            list_->setCurrentItem(item);
        }
    }
    list_->expandAll();
    search(search_->text());
    followRow();
}

void ShortcutSheet::search(const QString& words) {
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* group = list_->topLevelItem(i);
        bool any = false;
        for (int k = 0; k < group->childCount(); ++k) {
            QTreeWidgetItem* item = group->child(k);
            const QString text =
                QStringList{group->text(0), item->text(0), item->text(1), item->toolTip(0)}.join(
                    ' ');
            const bool isFound = hasAllWords(text, words);
            item->setHidden(!isFound);
            any |= isFound;
        }
        group->setHidden(!any);
    }
}

const Command* ShortcutSheet::current() const {
    const QTreeWidgetItem* item = list_->currentItem();
    const QVariant place = item ? item->data(0, Qt::UserRole) : QVariant();
    const bool isCommand = place.isValid() && place.toInt() >= 0;
    return isCommand ? &keys_.commands()[static_cast<std::size_t>(place.toInt())] : nullptr;
}

void ShortcutSheet::followRow() {
    const Command* command = current();
    edit_->setEnabled(command);
    edit_->setKeySequence(command ? command->action->shortcut() : QKeySequence());
    reset_->setEnabled(command && keys_.isChanged(*command));
    followKeys();
}

/// Says which command has the keys before they are taken from it.
void ShortcutSheet::followKeys() {
    const Command* command = current();
    const QKeySequence keys = edit_->keySequence();
    const bool isNew = command && keys != command->action->shortcut();
    const Command* holder = command ? keys_.holderOf(keys, *command) : nullptr;
    set_->setEnabled(isNew);
    conflict_->setText(holder ? tr("%1 is the key of \u201c%2\u201d, which loses it.")
                                    .arg(keys.toString(QKeySequence::NativeText), holder->name)
                              : QString());
}

void ShortcutSheet::set() {
    if (const Command* command = current()) {
        keys_.setKeys(*command, edit_->keySequence());
    }
}

} // namespace patina
