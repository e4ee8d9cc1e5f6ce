// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/fresnel_dock.h"

#include <QLabel>

#include "docks/block_chooser.h"
#include "docks/panel.h"
#include "parameters/document_form.h"

namespace patina {

FresnelDock::FresnelDock(const DockContext& context)
    : document_(context.document),
      chooser_(new BlockChooser(document_, kinds::fresnel, BlockChooser::Off::Offered, this)),
      hint_(hintLabel(this)) {
    chooser_->setAccessibleName(tr("Kind of Fresnel term"));
    fillPanel(this, {labelled(tr("&Kind"), chooser_), hint_},
              new DocumentForm(document_, context.textures, kinds::fresnel));
    connect(chooser_, &BlockChooser::chosen, this, [this](const QString& id) {
        document_.setBlock(document_.selection().currentPath(kinds::fresnel), id.toStdString());
    });
    onChange(document_, DocumentChange::Material | DocumentChange::Current | DocumentChange::Scene,
             this, &FresnelDock::update);
    update();
}

void FresnelDock::update() {
    const Material* material = document_.material(document_.selection().side());
    const BlockValues* part = material ? material->part(kinds::fresnel) : nullptr;
    chooser_->setEnabled(material != nullptr);
    chooser_->show(part ? QString::fromStdString(part->id) : QString());
    const Block* model =
        material ? document_.catalog().find(kinds::models, material->model.id) : nullptr;
    const bool hasSlot = model && model->slot(kinds::fresnel);
    hint_->setText(hasSlot ? tr("The model uses it for its highlight.")
                           : tr("Blends the shaded colour towards its tint at grazing angles."));
}

} // namespace patina
