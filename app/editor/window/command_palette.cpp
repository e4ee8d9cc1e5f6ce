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
constexpr std::size_t maxPlaces = 100; ///< more words find fewer

/// Tells whether each of the words begins a word of a text, or is in it somewhere.
enum class Fit { Begins, Within, None };

Fit fitOf(const QString& text, const QString& words) {
    return hasAllWords(text, words, Words::Begun)    ? Fit::Begins
           : hasAllWords(text, words, Words::Within) ? Fit::Within
                                                     : Fit::None;
}

/// Gathers the places of what fits, better ones first.
class Ranking {
  public:
    /// Adds a place with a rank, 0 for the best, among those that fit as well.
    void add(std::size_t place, Fit fit, std::size_t rank) {
        if (fit != Fit::None) {
            places_.push_back({{static_cast<std::size_t>(fit), rank}, place});
        }
    }

    std::vector<std::size_t> places() {
        std::ranges::stable_sort(places_, {}, &Placed::order);
        std::vector<std::size_t> all;
        for (const Placed& each : places_) {
            all.push_back(each.place);
        }
        return all;
    }

  private:
    struct Placed {
        std::pair<std::size_t, std::size_t> order;
        std::size_t place = 0;
    };

    std::vector<Placed> places_;
};

/// Returns the places of what has all words, those before the rest whose words begin with them:
/// commands that have them in their own name, then those that have them in the names of their
/// menus, then choices, whose places follow those of the commands, then panels that have them in
/// what they hold.
std::vector<std::size_t> found(const std::vector<Command>& commands,
                               const std::vector<NamedChoice>& choices, const QString& words) {
    constexpr std::size_t sameName = 2;
    constexpr std::size_t choiceRank = 3;
    constexpr std::size_t contentRank = 4;
    Ranking ranking;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        const Command& command = commands[i];
        const std::pair<QString, std::size_t> texts[] = {
            {command.id.section('/', -1), 0},
            {command.id, 1},
            {command.id + ' ' + command.action->whatsThis(), contentRank}};
        const auto better = [&](const auto& a, const auto& b) {
            return fitOf(a.first, words) < fitOf(b.first, words);
        };
        const auto& best = *std::ranges::min_element(texts, better);
        if (command.action->isEnabled()) {
            ranking.add(i, fitOf(best.first, words), best.second);
        }
    }
    for (std::size_t i = 0; i < choices.size() && !words.trimmed().isEmpty(); ++i) {
        const NamedChoice& choice = choices[i];
        const bool isCalledSo = choice.name.compare(words.trimmed(), Qt::CaseInsensitive) == 0;
        ranking.add(commands.size() + i, fitOf(choice.kind + ' ' + choice.name, words),
                    isCalledSo ? sameName : choiceRank);
    }
    std::vector<std::size_t> places = ranking.places();
    if (!words.trimmed().isEmpty()) {
        places.resize(std::min(places.size(), maxPlaces));
    }
    return places;
}

} // namespace

CommandPalette::CommandPalette(const CommandKeys& keys, std::vector<NamedChoice> choices,
                               QWidget* parent)
    : QDialog(parent), keys_(keys), choices_(std::move(choices)), search_(new QLineEdit(this)),
      list_(new QListWidget(this)),
      none_(new QLabel(tr("No command, panel, model, preset or lighting has these words."), this)) {
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

bool hasAllWords(const QString& text, const QString& words, Words how) {
    static const QRegularExpression between(QStringLiteral("[\\s:/\u203a]+"));
    return std::ranges::all_of(words.split(between, Qt::SkipEmptyParts), [&](const QString& word) {
        qsizetype at = text.indexOf(word, 0, Qt::CaseInsensitive);
        while (how == Words::Begun && at > 0 && text[at - 1].isLetterOrNumber()) {
            at = text.indexOf(word, at + 1, Qt::CaseInsensitive);
        }
        return at >= 0;
    });
}

} // namespace patina
