// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/fog_dock.h"

#include "docks/block_chooser.h"
#include "docks/panel.h"
#include "parameters/document_form.h"

namespace patina {

FogDock::FogDock(const DockContext& context)
    : document_(context.document),
      chooser_(new BlockChooser(document_, kinds::fog, BlockChooser::Off::Offered, this)) {
    chooser_->setAccessibleName(tr("Kind of fog"));
    fillPanel(this, {labelled(tr("&Kind"), chooser_)},
              new DocumentForm(document_, context.textures, kinds::fog));
    connect(chooser_, &BlockChooser::chosen, this, [this](const QString& id) {
        document_.setBlock(pathOf(kinds::fog), id.toStdString());
    });
    onChange(document_, DocumentChange::Block | DocumentChange::Scene, this, &FogDock::update);
    update();
}

void FogDock::update() {
    const BlockValues* fog = document_.scene().part(kinds::fog);
    chooser_->show(fog ? QString::fromStdString(fog->id) : QString());
}

} // namespace patina
