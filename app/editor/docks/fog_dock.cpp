// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/fog_dock.h"

#include "docks/block_chooser.h"
#include "parameters/document_form.h"
#include "docks/panel.h"

namespace patina {

FogDock::FogDock(const DockContext& context)
    : document_(context.document),
      chooser_(new BlockChooser(document_, "fog", BlockChooser::Off::Offered, this)) {
    chooser_->setAccessibleName(tr("Kind of fog"));
    fillPanel(this, {labelled(tr("&Kind"), chooser_)},
              new DocumentForm(document_, BlockPath::Part::Fog));
    connect(chooser_, &BlockChooser::chosen, this,
            [this](const QString& id) { document_.setFog(id.toStdString()); });
    connect(&document_, &Document::fogReplaced, this, &FogDock::update);
    connect(&document_, &Document::sceneReplaced, this, &FogDock::update);
    update();
}

void FogDock::update() {
    const std::optional<BlockValues>& fog = document_.scene().fog;
    chooser_->show(fog ? QString::fromStdString(fog->id) : QString());
}

} // namespace patina
