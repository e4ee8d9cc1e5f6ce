// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/parameters_dock.h"

#include <QGroupBox>
#include <QVBoxLayout>

#include "docks/panel.h"
#include "docks/slot_panel.h"
#include "parameters/document_form.h"

namespace patina {

ParametersDock::ParametersDock(const DockContext& context)
    : document_(context.document), accuracy_(new QGroupBox(tr("Accuracy"))) {
    accuracy_->setToolTip(tr("The same look, computed exactly or more cheaply"));
    auto* inside = new QVBoxLayout(accuracy_);
    inside->addWidget(new DocumentForm(document_, context.textures, settings::accuracy));
    auto* both = new QWidget;
    auto* layout = new QVBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new DocumentForm(document_, context.textures, kinds::models));
    layout->addWidget(new SlotPanel(document_, context.textures, kinds::specular, tr("Highlight")));
    layout->addWidget(accuracy_);
    fillPanel(this, {}, both);
    onChange(document_,
             DocumentChange::Material | DocumentChange::Current | DocumentChange::Scene |
                 DocumentChange::Catalog,
             this, &ParametersDock::update);
    update();
}

void ParametersDock::update() {
    const Block* choices = document_.block(document_.currentPath(settings::accuracy));
    accuracy_->setVisible(choices && !choices->parameters.empty());
}

} // namespace patina
