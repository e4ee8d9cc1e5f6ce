// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/command_palette.h"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QVBoxLayout>

#include "window/command_keys.h"

namespace patina {
namespace {

constexpr QSize paletteSize(460, 320);
constexpr std::size_t maxChoices = 100; ///< more words find fewer

/// Returns the places of the choices that have all words, the one that is called so first.
std::vector<std::size_t> found(const std::vector<NamedChoice>& choices, const QString& words) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < choices.size() && !words.isEmpty(); ++i) {
        if (hasAllWords(choices[i].kind + ' ' + choices[i].name, words)) {
            places.push_back(i);
        }
    }
    std::ranges::stable_partition(places, [&](std::size_t place) {
        return choices[place].name.compare(words, Qt::CaseInsensitive) == 0;
    });
    places.resize(std::min(places.size(), maxChoices));
    return places;
}

/// Returns the places of what has all words: commands that have them in their own name first, then
/// those that have them in the names of their menus, then choices, whose places follow those of the
/// commands, then panels that have them in what they hold.
std::vector<std::size_t> found(const std::vector<Command>& commands,
                               const std::vector<NamedChoice>& choices, const QString& words) {
    std::vector<std::size_t> ranks[3];
    for (std::size_t i = 0; i < commands.size(); ++i) {
        const Command& command = commands[i];
        const QString texts[] = {command.id.section('/', -1), command.id,
                                 command.id + ' ' + command.action->whatsThis()};
        const auto* const text = std::ranges::find_if(
            texts, [&words](const QString& each) { return hasAllWords(each, words); });
        if (command.action->isEnabled() && text != std::end(texts)) {
            ranks[text - std::begin(texts)].push_back(i);
        }
    }
    ranks[0].insert(ranks[0].end(), ranks[1].begin(), ranks[1].end());
    for (const std::size_t place : found(choices, words.trimmed())) {
        ranks[0].push_back(commands.size() + place);
    }
    ranks[0].insert(ranks[0].end(), ranks[2].begin(), ranks[2].end());
    return ranks[0];
}

} // namespace

CommandPalette::CommandPalette(const CommandKeys& keys, std::vector<NamedChoice> choices,
                               QWidget* parent)
    : QDialog(parent), keys_(keys), choices_(std::move(choices)), search_(new QLineEdit(this)),
      list_(new QListWidget(this)),
      none_(new QLabel(tr("No command, panel, model or preset has these words."), this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("commandPalette");
    setWindowTitle(tr("Run a Command"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(search_);
    layout->addWidget(list_);
    layout->addWidget(none_);
    search_->setPlaceholderText(tr("What is it called?"));
    search_->setAccessibleName(tr("Name of a command"));
    search_->installEventFilter(this);
    list_->setAccessibleName(tr("Commands"));
    list_->setUniformItemSizes(true);
    connect(search_, &QLineEdit::textChanged, this, &CommandPalette::fill);
    connect(search_, &QLineEdit::returnPressed, this, [this] { run(list_->currentItem()); });
    connect(list_, &QListWidget::itemActivated, this, &CommandPalette::run);
    resize(paletteSize);
    fill({});
}

void CommandPalette::fill(const QString& words) {
    list_->clear();
    for (const std::size_t place : found(keys_.commands(), choices_, words)) {
        auto* item = new QListWidgetItem(textOf(place), list_);
        item->setData(Qt::UserRole, static_cast<int>(place));
    }
    list_->setCurrentRow(0);
    none_->setVisible(list_->count() == 0);
}

QString CommandPalette::textOf(std::size_t place) const {
    const std::vector<Command>& commands = keys_.commands();
    if (place >= commands.size()) {
        const NamedChoice& choice = choices_[place - commands.size()];
        return tr("%1: %2").arg(choice.kind, choice.name);
    }
    const Command& command = commands[place];
    const QString path = QString(command.id).replace('/', QStringLiteral(" \u203a "));
    const QString shortcut = command.action->shortcut().toString(QKeySequence::NativeText);
    return shortcut.isEmpty() ? path : QStringLiteral("%1   (%2)").arg(path, shortcut);
}

/// Closes the dialog first: the command may open another one, or need the focus in a view. A panel
/// is brought up, also one that is open behind another.
void CommandPalette::run(const QListWidgetItem* item) {
    if (item) {
        const auto place = static_cast<std::size_t>(item->data(Qt::UserRole).toInt());
        if (place >= keys_.commands().size()) {
            const auto choose = choices_[place - keys_.commands().size()].choose;
            accept();
            choose();
            return;
        }
        QAction* action = keys_.commands()[place].action;
        accept();
        if (auto* panel = qobject_cast<QDockWidget*>(action->parent())) {
            panel->show();
            panel->raise();
            return;
        }
        action->trigger();
    }
}

/// Moves the current row by the arrow keys while the focus stays in the search field.
bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
        if (step != 0) {
            list_->setCurrentRow(
                std::clamp(list_->currentRow() + step, 0, std::max(list_->count() - 1, 0)));
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

bool hasAllWords(const QString& text, const QString& words) {
    static const QRegularExpression between(QStringLiteral("[\\s:/\u203a]+"));
    return std::ranges::all_of(words.split(between, Qt::SkipEmptyParts), [&](const QString& word) {
        return text.contains(word, Qt::CaseInsensitive);
    });
}

} // namespace patina
