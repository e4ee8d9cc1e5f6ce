// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/presets_dock.h"

#include <algorithm>

#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QShortcut>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include "docks/notice_bar.h"
#include "docks/panel.h"
#include "docks/preset_filter_menu.h"
#include "docks/preset_view.h"
#include "docks/search_box.h"
#include "docks/variant_changes_dialog.h"
#include "document/document.h"
#include "document/tried_material.h"
#include "files/file_actions.h"
#include "library/preset_library.h"
#include "library/thumbnail_maker.h"
#include "material/variant.h"
#include "session/session.h"
#include "viewport/compare_area.h"

namespace patina {
namespace {

constexpr int defaultPictureSize = 72;

struct NamedOrder {
    PresetOrder order;
    const char* id; ///< in the session
    const char* label;
};

constexpr NamedOrder orders[] = {{PresetOrder::Name, "name", QT_TR_NOOP("By name")},
                                 {PresetOrder::Date, "date", QT_TR_NOOP("Newest first")},
                                 {PresetOrder::Model, "model", QT_TR_NOOP("By model")}};

} // namespace

PresetsDock::PresetsDock(const DockContext& context)
    : context_(context), presets_(context.presets), search_(new SearchBox(this)),
      filter_(new PresetFilterMenu(presets_, this)), filterButton_(new QToolButton(this)),
      hint_(hintLabel(this)),
      view_(new PresetView(*new PresetList(presets_.marks(), this), context.thumbnails, this)),
      size_(new QSlider(Qt::Horizontal, this)), count_(new QLabel(this)),
      notice_(new NoticeBar(this)),
      back_(new QShortcut(Qt::Key_Escape, this, nullptr, nullptr, Qt::ApplicationShortcut)),
      edits_(presets_), bundles_(context.thumbnails) {
    const Session::PresetsLook look = context_.session.presetsLook();
    for (const NamedOrder& each : orders) {
        order_ = look.order == QLatin1String(each.id) ? each.order : order_;
    }
    view_->setAsList(look.asList);
    view_->setPictureSize(look.pictureSize > 0 ? look.pictureSize : defaultPictureSize);
    back_->setEnabled(false);
    build();
    connectParts();
    connectBundles();
    addActions();
    fill();
}

void PresetsDock::build() {
    auto* save =
        textButton(tr("Save…"), tr("Save the active material as a preset of your own"), this);
    connect(save, &QToolButton::clicked, &context_.files, &FileActions::exportPreset);
    auto* more = new QMenu(save);
    more->addAction(tr("Import presets…"), this, &PresetsDock::importBundle);
    more->addAction(tr("Export these presets…"), this, &PresetsDock::exportBundle)
        ->setToolTip(tr("Those that are selected, or all that are shown, in one zip file"));
    more->addAction(tr("Add a folder…"), filter_, &PresetFilterMenu::askForFolder);
    save->setMenu(more);
    save->setPopupMode(QToolButton::MenuButtonPopup);
    search_->setPlaceholderText(tr("Search"));
    search_->setToolTip(tr("Words of the name, tags, model, description or author"));
    search_->setClearButtonEnabled(true);
    search_->setAccessibleName(tr("Search presets"));
    view_->setAccessibleName(tr("Presets"));
    view_->setContextMenuPolicy(Qt::CustomContextMenu);
    filterButton_->setMenu(filter_);
    filterButton_->setPopupMode(QToolButton::InstantPopup);
    filterButton_->setToolTip(tr("Show presets of a model, tag or folder, or favourites only"));
    filterButton_->setAccessibleName(tr("Which presets are shown"));
    filterButton_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    size_->setRange(PresetView::minPictureSize, PresetView::maxPictureSize);
    size_->setValue(view_->pictureSize());
    size_->setToolTip(tr("How large the pictures are"));
    size_->setAccessibleName(size_->toolTip());
    size_->setFixedWidth(90);
    count_->setForegroundRole(QPalette::PlaceholderText);
    count_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 2);
    layout->setSpacing(4);
    layout->addWidget(rowOf({search_, save}));
    layout->addWidget(rowOf({filterButton_, orderButton(), listButton()}));
    layout->addWidget(hint_);
    layout->addWidget(view_, 1);
    layout->addWidget(notice_);
    layout->addWidget(rowOf({count_, size_}));
}

QToolButton* PresetsDock::orderButton() {
    QToolButton* button = textButton(tr("Sort"), tr("The order of the presets"), this);
    auto* menu = new QMenu(button);
    auto* group = new QActionGroup(menu);
    for (const NamedOrder& each : orders) {
        QAction* action = menu->addAction(tr(each.label));
        action->setCheckable(true);
        action->setChecked(each.order == order_);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, order = each.order] {
            order_ = order;
            storeLook();
            fill();
        });
    }
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
    return button;
}

QToolButton* PresetsDock::listButton() {
    QToolButton* button =
        textButton(tr("List"), tr("A list with model and tags in place of the grid"), this);
    button->setCheckable(true);
    button->setChecked(view_->isAsList());
    connect(button, &QToolButton::toggled, this, [this](bool on) {
        view_->setAsList(on);
        storeLook();
    });
    return button;
}

void PresetsDock::connectParts() {
    connect(search_, &QLineEdit::textChanged, this, &PresetsDock::fill);
    connect(search_, &QLineEdit::returnPressed, this, [this] { apply(view_->current()); });
    connect(filter_, &PresetFilterMenu::filterChanged, this, &PresetsDock::fill);
    connect(view_, &PresetView::tried, this, &PresetsDock::tryOut);
    connect(view_, &PresetView::applied, this, &PresetsDock::apply);
    connect(view_, &PresetView::selectedChanged, this, [this] {
        say();
        updateActions();
    });
    connect(view_, &QWidget::customContextMenuRequested, this, &PresetsDock::showMenu);
    connect(size_, &QSlider::valueChanged, view_, &PresetView::setPictureSize);
    connect(size_, &QSlider::valueChanged, this, &PresetsDock::storeLook);
    connect(&presets_, &PresetLibrary::changed, this, &PresetsDock::fill);
    connect(&presets_, &PresetLibrary::checked, this, &PresetsDock::say);
    connect(&presets_, &PresetLibrary::variantsChanged, this, &PresetsDock::tellVariants);
    connect(&presets_.marks(), &PresetMarks::changed, this, [this] {
        updateActions();
        if (filter_->filter().favourites || filter_->filter().recent) {
            fill();
        }
    });
    connect(&context_.files, &FileActions::presetApplied, &presets_.marks(),
            &PresetMarks::noteUsed);
    connect(back_, &QShortcut::activated, this, &PresetsDock::endTrying);
    connect(&context_.tried, &TriedMaterial::changed, this, [this] {
        if (!context_.tried.isShown()) {
            endTrying();
        }
    });
    connect(qApp, &QApplication::focusChanged, this,
            [this](const QWidget*, const QWidget* now) { followFocus(now); });
    onChange(context_.document, DocumentChange::Catalog, view_, &PresetView::wishAnew);
}

void PresetsDock::fill() {
    PresetFilter filter = filter_->filter();
    filter.search = search_->text();
    view_->setRows(chosen(presets_.entries(), filter, order_, presets_.marks()));
    filterButton_->setText(filter_->summary());
    chooseAShownOne();
    say();
}

void PresetsDock::say() {
    const auto all = static_cast<int>(presets_.entries().size());
    const int shown = view_->model()->rowCount();
    const auto selected = static_cast<int>(view_->selected().size());
    count_->setText(selected > 1   ? tr("%1 of %2 selected").arg(selected).arg(shown)
                    : shown == all ? tr("%1 presets").arg(all)
                                   : tr("%1 of %2").arg(shown).arg(all));
    hint_->setText(!presets_.isRead() && all == 0 ? tr("The presets are being read…")
                   : all == 0                     ? tr("There are no presets yet.")
                                                  : tr("No preset matches."));
    hint_->setVisible(shown == 0);
}

/// What Enter puts on a side is to be seen.
void PresetsDock::chooseAShownOne() {
    const bool isSearching = !search_->text().trimmed().isEmpty();
    if (isSearching && !view_->current() && view_->model()->rowCount() > 0) {
        view_->setCurrentIndex(view_->model()->index(0, 0));
    }
}

void PresetsDock::tryOut(const PresetPtr& entry) {
    context_.tried.show(context_.document.selection().side(), entry->material);
    if (!context_.tried.isShown()) {
        return;
    }
    tried_ = entry;
    back_->setEnabled(true);
    notice_->say(tr("Trying %1").arg(entry->name),
                 {{tr("Apply"), tr("Put it on the side (Enter)"), [this] { apply(tried_); }},
                  {tr("Back"), tr("Show the material again (Esc)"), [this] { endTrying(); }}});
}

void PresetsDock::endTrying() {
    if (tried_) {
        tried_.reset();
        back_->setEnabled(false);
        notice_->clear();
        context_.tried.end();
    }
}

void PresetsDock::apply(const PresetPtr& entry) {
    const PresetPtr applied = entry; // which ending may let go of
    endTrying();
    if (applied) {
        context_.files.applyPreset(applied->path, context_.document.selection().side());
    }
}

/// Who looks at what is tried from elsewhere, in a view, goes on trying it.
void PresetsDock::followFocus(const QWidget* now) {
    if (tried_ && now && !isAncestorOf(now) && !context_.views.isAncestorOf(now)) {
        endTrying();
    }
}

void PresetsDock::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && tried_) {
        endTrying();
        return;
    }
    QWidget::keyPressEvent(event);
}

void PresetsDock::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    if (!event->spontaneous()) {
        endTrying();
    }
}

/// The keys are the view's own.
QAction* PresetsDock::addFileAction(const QString& text, const QKeySequence& key,
                                    void (PresetsDock::*act)()) {
    auto* action = new QAction(text, view_);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetShortcut);
    connect(action, &QAction::triggered, this, act);
    view_->addAction(action);
    return action;
}

void PresetsDock::addActions() {
    rename_ = addFileAction(tr("Rename…"), Qt::Key_F2, &PresetsDock::rename);
    addFileAction(tr("Duplicate"), QKeySequence(QStringLiteral("Ctrl+D")), &PresetsDock::duplicate);
    addFileAction(tr("New variant"), QKeySequence(QStringLiteral("Ctrl+Shift+D")),
                  &PresetsDock::makeVariants);
    detach_ = addFileAction(tr("Detach from parent"), {}, &PresetsDock::detach);
    detach_->setToolTip(tr("Make it a preset of its own, which looks as it does now"));
    tags_ =
        addFileAction(tr("Tags…"), QKeySequence(QStringLiteral("Ctrl+T")), &PresetsDock::editTags);
    favourite_ = addFileAction(tr("Favourite"), QKeySequence(QStringLiteral("Ctrl+B")),
                               &PresetsDock::toggleFavourites);
    favourite_->setCheckable(true);
    trash_ = addFileAction(tr("Move to trash"), Qt::Key_Delete, &PresetsDock::moveToTrash);
    undo_ = addFileAction(tr("Undo"), QKeySequence::Undo, &PresetsDock::undoEdit);
    redo_ = addFileAction(tr("Redo"), QKeySequence::Redo, &PresetsDock::redoEdit);
    connect(&edits_, &PresetEdits::done, this, &PresetsDock::tellEdit);
    connect(&edits_.undoStack(), &QUndoStack::indexChanged, this, [this] {
        isLastEdit_ = true;
        updateActions();
    });
    connect(&context_.document.undoStack(), &QUndoStack::indexChanged, this, [this] {
        isLastEdit_ = false;
        updateActions();
    });
    updateActions();
}

void PresetsDock::updateActions() {
    const std::vector<PresetPtr> chosen = view_->selected();
    const auto isOwn = [](const PresetPtr& entry) { return !entry->shipped; };
    const bool hasOwn = std::ranges::any_of(chosen, isOwn);
    rename_->setEnabled(chosen.size() == 1 && hasOwn);
    detach_->setVisible(std::ranges::any_of(chosen, [](const PresetPtr& entry) {
        return !entry->shipped && !parentOf(entry->material).empty();
    }));
    tags_->setEnabled(hasOwn);
    trash_->setEnabled(hasOwn);
    favourite_->setEnabled(!chosen.empty());
    favourite_->setChecked(!chosen.empty() &&
                           std::ranges::all_of(chosen, [this](const PresetPtr& entry) {
                               return presets_.marks().isFavourite(entry->path);
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

void PresetsDock::showMenu(const QPoint& place) {
    if (!view_->indexAt(place).isValid() || !view_->current()) {
        return;
    }
    const PresetPtr entry = view_->current();
    QMenu menu;
    if (view_->selected().size() == 1) {
        const auto put = [this, file = entry->path](Side side) {
            endTrying();
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
    updateActions();
    menu.addActions(view_->actions());
    menu.exec(view_->viewport()->mapToGlobal(place));
}

void PresetsDock::rename() {
    const PresetPtr entry = view_->current();
    bool isAgreed = false;
    const QString name =
        QInputDialog::getText(this, tr("Rename"), tr("The preset's name; its file keeps its own"),
                              QLineEdit::Normal, entry->name, &isAgreed)
            .trimmed();
    if (isAgreed && !name.isEmpty() && name != entry->name) {
        edits_.rename(entry, name);
    }
}

void PresetsDock::duplicate() {
    edits_.duplicate(view_->selected());
}

void PresetsDock::makeVariants() {
    edits_.makeVariants(view_->selected());
}

void PresetsDock::detach() {
    edits_.detach(view_->selected());
}

/// Offers the tags that all selected presets have: what is taken away there goes from each, what is
/// added comes to each.
void PresetsDock::editTags() {
    const std::vector<PresetPtr> chosen = view_->selected();
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
    const QString answer = QInputDialog::getText(this, tr("Tags"), question, QLineEdit::Normal,
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

void PresetsDock::toggleFavourites() {
    edits_.setFavourites(view_->selected(), favourite_->isChecked());
}

void PresetsDock::moveToTrash() {
    endTrying();
    edits_.moveToTrash(view_->selected());
}

void PresetsDock::tellVariants(const std::vector<VariantChange>& changes) {
    const QString text = changes.size() == 1
                             ? tr("%1 changed with its parent").arg(changes.front().after->name)
                             : tr("%1 variants changed with their parent").arg(changes.size());
    notice_->say(text, {{tr("Show"), tr("Show them before and after"),
                         [this, changes] {
                             VariantChangesDialog(changes, context_.thumbnails, this).exec();
                         }},
                        {tr("OK"), tr("Close this note"), [this] { notice_->clear(); }}});
}

void PresetsDock::undoEdit() {
    edits_.undoStack().undo();
}

void PresetsDock::redoEdit() {
    edits_.undoStack().redo();
}

/// What was not done is a message each.
void PresetsDock::tellEdit(const QString& what, const std::vector<PresetOutcome>& outcomes) {
    const auto failed = std::ranges::count_if(
        outcomes, [](const PresetOutcome& outcome) { return !outcome.isDone(); });
    for (const PresetOutcome& outcome : outcomes) {
        if (!outcome.isDone()) {
            context_.files.tell({outcome.entry->file.string(), 0, 0, outcome.problem, {}});
        }
    }
    sayDone(failed == 0
                ? what
                : tr("%1: not done for %2 of %3").arg(what).arg(failed).arg(outcomes.size()));
}

/// With a button that takes it back.
void PresetsDock::sayDone(const QString& text) {
    notice_->say(text, {{tr("Undo"), tr("Take it back (Ctrl+Z in the presets)"),
                         [this] {
                             notice_->clear();
                             undoEdit();
                         }},
                        {tr("OK"), tr("Close this note"), [this] { notice_->clear(); }}});
}

void PresetsDock::connectBundles() {
    connect(&bundles_, &PresetBundles::drawn, this, [this](int pictures, int of) {
        notice_->say(tr("Exporting: %1 of %2 pictures").arg(pictures).arg(of),
                     {{tr("Cancel"), tr("Export nothing"), [this] {
                           bundles_.cancelExport();
                           notice_->clear();
                       }}});
    });
    connect(&bundles_, &PresetBundles::exported, this,
            [this](const QString& file, const std::vector<BundleOutcome>& outcomes) {
                const QString done = tr("%1 is written").arg(QFileInfo(file).fileName());
                notice_->say(toldBundle(done, outcomes),
                             {{tr("OK"), tr("Close this note"), [this] { notice_->clear(); }}});
            });
    connect(&bundles_, &PresetBundles::imported, this,
            [this](const QString& folder, const std::vector<BundleOutcome>& outcomes) {
                presets_.scan();
                edits_.noteImport(folder);
                sayDone(toldBundle(tr("Imported into %1").arg(QDir(folder).dirName()), outcomes));
            });
    connect(&edits_, &PresetEdits::importFailed, this,
            [this](const QString& folder, const QString& problem) {
                context_.files.tell({folder.toStdString(), 0, 0, problem.toStdString(), {}});
            });
    connect(&bundles_, &PresetBundles::failed, &context_.files, &FileActions::tell);
}

void PresetsDock::exportBundle() {
    std::vector<PresetPtr> chosen = view_->selected();
    if (chosen.size() < 2) {
        chosen = view_->shown();
    }
    const QString file = QFileDialog::getSaveFileName(
        this, tr("Export %1 presets").arg(chosen.size()),
        context_.session.folder("bundle") + QStringLiteral("/presets.zip"),
        tr("Bundles of presets (*.zip)"));
    if (!file.isEmpty() && !chosen.empty()) {
        context_.session.setFolderOf("bundle", file);
        bundles_.exportTo(file, chosen);
    }
}

void PresetsDock::importBundle() {
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Import presets"), context_.session.folder("bundle"),
                                     tr("Bundles of presets (*.zip)"));
    if (!file.isEmpty()) {
        context_.session.setFolderOf("bundle", file);
        bundles_.importFrom(file, PresetLibrary::userFolder());
    }
}

/// Sends a message for each file that was not done, and returns what is said of all.
QString PresetsDock::toldBundle(const QString& done, const std::vector<BundleOutcome>& outcomes) {
    int failed = 0;
    for (const BundleOutcome& outcome : outcomes) {
        if (!outcome.problem.empty()) {
            context_.files.tell({outcome.name, 0, 0, outcome.problem, {}});
            ++failed;
        }
    }
    return failed == 0 ? done : tr("%1, but for %2 files").arg(done).arg(failed);
}

void PresetsDock::storeLook() {
    for (const NamedOrder& each : orders) {
        if (each.order == order_) {
            context_.session.setPresetsLook(
                {view_->pictureSize(), view_->isAsList(), QString::fromLatin1(each.id)});
        }
    }
}

} // namespace patina
