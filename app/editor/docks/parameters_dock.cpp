// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/parameters_dock.h"

#include <utility>

#include <QGroupBox>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "docks/material_actions.h"
#include "docks/notice_bar.h"
#include "docks/panel.h"
#include "docks/part_panel.h"
#include "parameters/choice_box.h"
#include "parameters/document_form.h"

namespace patina {
namespace {

/// Is how long a press lasts at least to count as held.
constexpr int holdMs = 350;

} // namespace

ParametersDock::ParametersDock(const DockContext& context)
    : document_(context.document), material_(context.material),
      original_(textButton(tr("Original"),
                           tr("The material as it was opened or applied; hold the button for a "
                              "look (O in a view)"),
                           this)),
      notice_(new NoticeBar(this)), accuracy_(new QGroupBox(tr("Accuracy"))) {
    accuracy_->setToolTip(tr("The same look, computed exactly or more cheaply"));
    auto* model = new DocumentForm(document_, context.textures, kinds::models);
    auto* slot = new PartPanel(document_, context.textures, kinds::specular, tr("Highlight"));
    auto* levels = new DocumentForm(document_, context.textures, settings::accuracy);
    forms_ = {model, &slot->form(), levels};
    auto* inside = new QVBoxLayout(accuracy_);
    inside->addWidget(levels);
    auto* both = new QWidget;
    auto* layout = new QVBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(model);
    layout->addWidget(slot);
    layout->addWidget(accuracy_);
    auto* more = textButton(QStringLiteral("\u22ef"), tr("What can be done to the material"), this);
    auto* menu = new QMenu(more);
    menu->setToolTipsVisible(true);
    menu->addActions({material_.all().begin(), material_.all().end()});
    more->setMenu(menu);
    more->setPopupMode(QToolButton::InstantPopup);
    fillPanel(this, {rowOf({filterBox(), original_, more}), notice_}, both);
    connectOriginal();
    onChange(document_,
             DocumentChange::Material | DocumentChange::Current | DocumentChange::Scene |
                 DocumentChange::Catalog,
             this, &ParametersDock::update);
    update();
}

QWidget* ParametersDock::filterBox() {
    auto* box = new ChoiceBox(this);
    box->setObjectName("rowFilter");
    box->setAccessibleName(tr("Which values are shown"));
    box->setToolTip(tr("All values, those that count at present, or those that are changed or have "
                       "an image"));
    for (const auto& [text, filter] :
         {std::pair(tr("All values"), RowFilter::All), std::pair(tr("In use"), RowFilter::Active),
          std::pair(tr("Changed"), RowFilter::Changed)}) {
        box->addItem(text, static_cast<int>(filter));
    }
    connect(box, &QComboBox::currentIndexChanged, this,
            [this, box] { setFilter(static_cast<RowFilter>(box->currentData().toInt())); });
    return box;
}

void ParametersDock::setFilter(RowFilter filter) {
    for (ParameterForm* form : forms_) {
        form->setFilter(filter);
    }
}

void ParametersDock::connectOriginal() {
    QAction* action = material_.original();
    original_->setObjectName("original");
    original_->setCheckable(true);
    const auto follow = [this, action] {
        original_->setChecked(action->isChecked());
        original_->setEnabled(action->isEnabled());
        showNotice();
    };
    connect(action, &QAction::changed, this, follow);
    connect(original_, &QToolButton::clicked, this, follow); // only the action decides
    connect(original_, &QToolButton::pressed, this, [this, action] {
        wasOriginal_ = action->isChecked();
        held_.start();
        if (!wasOriginal_) {
            action->trigger();
        }
    });
    connect(original_, &QToolButton::released, this, [this, action] {
        if (action->isChecked() && (wasOriginal_ || held_.elapsed() > holdMs)) {
            action->trigger();
        }
        showNotice();
    });
    follow();
}

/// Does nothing while the button is held, since nothing may move under the pointer.
void ParametersDock::showNotice() {
    if (original_->isDown()) {
        return;
    }
    if (material_.original()->isChecked()) {
        notice_->say(tr("The views show the original"),
                     {{tr("Back"), tr("Show what was edited"),
                       [this] { material_.original()->trigger(); }}});
    } else {
        notice_->clear();
    }
}

void ParametersDock::update() {
    const Block* choices = document_.block(document_.selection().currentPath(settings::accuracy));
    accuracy_->setVisible(choices && !choices->parameters.empty());
}

} // namespace patina
