// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/presets_dock.h"

#include <QActionGroup>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
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
#include "files/file_actions.h"
#include "library/preset_library.h"
#include "session/session.h"

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
      notice_(new NoticeBar(this)), trial_(context, *notice_, *this),
      actions_(context, *view_, trial_, *notice_), transfer_(context, *notice_, *this),
      steps_(context.document, presets_, context.files) {
    const Session::PresetsLook look = context_.session.presetsLook();
    for (const NamedOrder& each : orders) {
        order_ = look.order == QLatin1String(each.id) ? each.order : order_;
    }
    view_->setAsList(look.asList);
    view_->setPictureSize(look.pictureSize > 0 ? look.pictureSize : defaultPictureSize);
    build();
    connectParts();
    fill();
}

void PresetsDock::build() {
    auto* save =
        textButton(tr("Save…"), tr("Save the active material as a preset of your own"), this);
    connect(save, &QToolButton::clicked, &context_.files.saving(), &SaveActions::exportPreset);
    auto* more = new QMenu(save);
    more->addAction(tr("Import presets…"), &transfer_, &PresetTransfer::importPresets);
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
    connect(search_, &QLineEdit::returnPressed, this, [this] { trial_.apply(view_->current()); });
    connect(filter_, &PresetFilterMenu::filterChanged, this, &PresetsDock::fill);
    connect(view_, &PresetView::tried, &trial_, &PresetTrial::begin);
    connect(view_, &PresetView::applied, &trial_, &PresetTrial::apply);
    connect(view_, &PresetView::stepped, this, &PresetsDock::step);
    const auto follow = [this] { view_->setArrowsAreSteps(context_.document.isComparing()); };
    onChange(context_.document, DocumentChange::Comparing, this, follow);
    follow();
    connect(view_, &PresetView::selectedChanged, this, [this] {
        say();
        actions_.update();
    });
    connect(view_, &QWidget::customContextMenuRequested, &actions_, &PresetActions::showMenu);
    connect(size_, &QSlider::valueChanged, view_, &PresetView::setPictureSize);
    connect(size_, &QSlider::valueChanged, this, &PresetsDock::storeLook);
    connect(&presets_, &PresetLibrary::changed, this, &PresetsDock::fill);
    connect(&presets_, &PresetLibrary::checked, this, &PresetsDock::say);
    connect(&presets_, &PresetLibrary::variantsChanged, this, &PresetsDock::tellVariants);
    connect(&presets_.marks(), &PresetMarks::changed, this, [this] {
        actions_.update();
        if (filter_->filter().favourites || filter_->filter().recent) {
            fill();
        }
    });
    connect(&context_.files, &FileActions::presetApplied, &presets_.marks(),
            &PresetMarks::noteUsed);
    connect(&transfer_, &PresetTransfer::imported, this,
            [this](const QString& folder, const QString& text) {
                presets_.scan();
                actions_.noteImport(folder, text);
            });
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

void PresetsDock::step(int by, bool isOther) {
    trial_.end();
    if (const PresetPtr applied = steps_.step(isOther ? Side::A : Side::B, by, view_->shown())) {
        view_->choose(applied);
    }
}

void PresetsDock::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && trial_.isGoingOn()) {
        trial_.end();
        return;
    }
    QWidget::keyPressEvent(event);
}

void PresetsDock::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    if (!event->spontaneous()) {
        trial_.end();
    }
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

/// Exports those that are selected, or all that are shown where there are not several.
void PresetsDock::exportBundle() {
    const std::vector<PresetPtr> chosen = view_->selected();
    transfer_.exportPresets(chosen.size() < 2 ? view_->shown() : chosen);
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
