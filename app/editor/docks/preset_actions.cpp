// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/preset_actions.h"

#include <algorithm>

#include <QInputDialog>
#include <QMenu>
#include <QScopedValueRollback>

#include "docks/notice_bar.h"
#include "docks/preset_trial.h"
#include "docks/preset_view.h"
#include "document/document.h"
#include "files/file_actions.h"
#include "library/preset_library.h"
#include "material/variant.h"

namespace patina {

PresetActions::PresetActions(const DockContext& context, PresetView& view, PresetTrial& trial,
                             NoticeBar& notice)
    : context_(context), view_(view), trial_(trial), notice_(notice), edits_(context.presets) {
    addAll();
}

void PresetActions::noteImport(const QString& folder, const QString& text) {
    edits_.noteImport(folder);
    sayDone(text, true);
}

/// The keys are the view's own.
QAction* PresetActions::add(const QString& text, const QKeySequence& key,
                            void (PresetActions::*act)()) {
    auto* action = new QAction(text, &view_);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetShortcut);
    connect(action, &QAction::triggered, this, act);
    view_.addAction(action);
    return action;
}

void PresetActions::addAll() {
    rename_ = add(tr("Rename…"), Qt::Key_F2, &PresetActions::rename);
    add(tr("Duplicate"), QKeySequence(QStringLiteral("Ctrl+D")), &PresetActions::duplicate);
    add(tr("New variant"), QKeySequence(QStringLiteral("Ctrl+Shift+D")),
        &PresetActions::makeVariants);
    detach_ = add(tr("Detach from parent"), {}, &PresetActions::detach);
    detach_->setToolTip(tr("Make it a preset of its own, which looks as it does now"));
    tags_ =
        add(tr("Tags…"), QKeySequence(QStringLiteral("Ctrl+Shift+T")), &PresetActions::editTags);
    favourite_ = add(tr("Favourite"), QKeySequence(QStringLiteral("Ctrl+Shift+F")),
                     &PresetActions::toggleFavourites);
    favourite_->setCheckable(true);
    trash_ = add(tr("Move to trash"), Qt::Key_Delete, &PresetActions::moveToTrash);
    undo_ = add(tr("Undo"), QKeySequence::Undo, &PresetActions::undo);
    redo_ = add(tr("Redo"), QKeySequence::Redo, &PresetActions::redo);
    connect(&edits_, &PresetEdits::importFailed, this,
            [this](const QString& folder, const QString& problem) {
                context_.files.report({folder.toStdString(), 0, 0, problem.toStdString(), {}});
            });
    connect(&edits_, &PresetEdits::done, this, &PresetActions::report);
    connect(&edits_.undoStack(), &QUndoStack::indexChanged, this, [this] {
        isLastEdit_ = true;
        update();
    });
    connect(&context_.document.undoStack(), &QUndoStack::indexChanged, this, [this] {
        isLastEdit_ = false;
        update();
    });
    update();
}

void PresetActions::update() {
    const std::vector<PresetPtr> chosen = view_.selected();
    const auto isOwn = [](const PresetPtr& entry) { return !entry->shipped; };
    const bool hasOwn = std::ranges::any_of(chosen, isOwn);
    rename_->setEnabled(hasOwn);
    detach_->setVisible(std::ranges::any_of(chosen, [](const PresetPtr& entry) {
        return !entry->shipped && !parentOf(entry->material).empty();
    }));
    tags_->setEnabled(hasOwn);
    trash_->setEnabled(hasOwn);
    favourite_->setEnabled(!chosen.empty());
    favourite_->setChecked(!chosen.empty() &&
                           std::ranges::all_of(chosen, [this](const PresetPtr& entry) {
                               return context_.presets.marks().isFavourite(entry->path);
                           }));
    const QUndoStack& edits = edits_.undoStack();
    const bool canUndo = isLastEdit_ && edits.canUndo();
    const bool canRedo = isLastEdit_ && edits.canRedo();
    undo_->setVisible(canUndo); // what is not shown cannot be enabled
    undo_->setEnabled(canUndo);
    undo_->setText(tr("Undo: %1").arg(edits.undoText()));
    redo_->setVisible(canRedo);
    redo_->setEnabled(canRedo);
    redo_->setText(tr("Redo: %1").arg(edits.redoText()));
}

void PresetActions::showMenu(const QPoint& place) {
    if (!view_.indexAt(place).isValid() || !view_.current()) {
        return;
    }
    const PresetPtr entry = view_.current();
    QMenu menu;
    if (view_.selected().size() == 1) {
        const auto put = [this, file = entry->path](Side side) {
            trial_.end();
            context_.files.applyPreset(file, side);
        };
        menu.addAction(tr("Put on side A"), this, [put] { put(Side::A); });
        menu.addAction(tr("Put on side B"), this, [put] { put(Side::B); });
        menu.addAction(entry->shipped ? tr("Open to edit a copy") : tr("Open to edit this file"),
                       this, [this, file = entry->path] {
                           context_.files.open({file}, context_.document.selection().side());
                       });
        menu.addSeparator();
    }
    update();
    menu.addActions(view_.actions());
    menu.exec(view_.viewport()->mapToGlobal(place));
}

void PresetActions::rename() {
    const std::vector<PresetPtr> chosen = view_.selected();
    if (chosen.empty()) {
        return;
    }
    const bool isOne = chosen.size() == 1;
    const QString question = isOne ? tr("The preset's name; its file keeps its own")
                                   : tr("Names of the %1 presets: {name} is the one that each has, "
                                        "{n} its number")
                                         .arg(chosen.size());
    const QString before = isOne ? chosen.front()->name : QStringLiteral("{name}");
    bool isAgreed = false;
    const QString name =
        QInputDialog::getText(&view_, tr("Rename"), question, QLineEdit::Normal, before, &isAgreed)
            .trimmed();
    if (isAgreed && !name.isEmpty() && name != before) {
        edits_.rename(chosen, name);
    }
}

void PresetActions::duplicate() {
    edits_.duplicate(view_.selected());
}

void PresetActions::makeVariants() {
    edits_.makeVariants(view_.selected());
}

void PresetActions::detach() {
    edits_.detach(view_.selected());
}

/// Offers the tags that all selected presets have: what is taken away there goes from each, what is
/// added comes to each.
void PresetActions::editTags() {
    const std::vector<PresetPtr> chosen = view_.selected();
    QStringList common;
    for (const std::string& tag : chosen.front()->material.tags) {
        if (std::ranges::all_of(chosen, [&tag](const PresetPtr& entry) {
                return std::ranges::count(entry->material.tags, tag) > 0;
            })) {
            common << QString::fromStdString(tag);
        }
    }
    bool isAgreed = false;
    const QString question = chosen.size() == 1
                                 ? tr("Tags, with commas between them")
                                 : tr("Tags that all %1 presets have").arg(chosen.size());
    const QString answer = QInputDialog::getText(&view_, tr("Tags"), question, QLineEdit::Normal,
                                                 common.join(QStringLiteral(", ")), &isAgreed);
    if (!isAgreed) {
        return;
    }
    QStringList wanted;
    for (const QString& tag : answer.split(',')) {
        if (!tag.trimmed().isEmpty()) {
            wanted << tag.trimmed();
        }
    }
    QStringList removed = common;
    removed.removeIf([&wanted](const QString& tag) { return wanted.contains(tag); });
    edits_.changeTags(chosen, wanted, removed);
}

void PresetActions::toggleFavourites() {
    edits_.setFavourites(view_.selected(), favourite_->isChecked());
}

void PresetActions::moveToTrash() {
    trial_.end();
    edits_.moveToTrash(view_.selected());
}

void PresetActions::undo() {
    const QScopedValueRollback<bool> undoing(isUndoing_, true);
    edits_.undoStack().undo();
}

void PresetActions::redo() {
    edits_.undoStack().redo();
}

/// What was not done is a message each.
void PresetActions::report(const QString& what, const std::vector<PresetOutcome>& outcomes) {
    const auto failed = std::ranges::count_if(
        outcomes, [](const PresetOutcome& outcome) { return !outcome.isDone(); });
    for (const PresetOutcome& outcome : outcomes) {
        if (!outcome.isDone()) {
            context_.files.report({outcome.entry->file.string(), 0, 0, outcome.problem, {}});
        }
    }
    const auto all = static_cast<std::ptrdiff_t>(outcomes.size());
    sayDone(failed == 0 ? what : tr("%1: not done for %2 of %3").arg(what).arg(failed).arg(all),
            failed < all || outcomes.empty());
}

/// Says what was done, with a button that takes it back, or that does again what was undone, where
/// anything was.
void PresetActions::sayDone(const QString& text, bool isAnyDone) {
    const auto button = [this](const QString& name, const QString& toolTip,
                               void (PresetActions::*act)()) {
        return NoticeBar::Action{name, toolTip, [this, act] {
                                     notice_.clear();
                                     (this->*act)();
                                 }};
    };
    std::vector<NoticeBar::Action> actions;
    if (isAnyDone) {
        actions.push_back(isUndoing_
                              ? button(tr("Redo"), tr("Do it again"), &PresetActions::redo)
                              : button(tr("Undo"), tr("Take it back (Ctrl+Z in the presets)"),
                                       &PresetActions::undo));
    }
    actions.push_back({tr("OK"), tr("Close this note"), [this] { notice_.clear(); }});
    notice_.say(text, actions);
}

} // namespace patina
