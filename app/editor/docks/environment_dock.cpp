// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/environment_dock.h"

#include <QLabel>

#include "docks/block_chooser.h"
#include "docks/panel.h"
#include "parameters/document_form.h"

namespace patina {

EnvironmentDock::EnvironmentDock(const DockContext& context)
    : document_(context.document),
      chooser_(new BlockChooser(document_, kinds::environment, BlockChooser::Off::Offered, this)) {
    chooser_->setAccessibleName(tr("Kind of environment"));
    QLabel* hint = hintLabel(this);
    hint->setText(tr("Drop an .hdr or .exr panorama on the view to light the scene with it. Its "
                     "light adds to that of the lights. Shift+right drag in a view turns it."));
    fillPanel(this, {labelled(tr("&Kind"), chooser_), hint},
              new DocumentForm(document_, context.textures, kinds::environment));
    connect(chooser_, &BlockChooser::chosen, this, [this](const QString& id) {
        document_.setBlock(pathOf(kinds::environment), id.toStdString());
    });
    onChange(document_, DocumentChange::Block | DocumentChange::Scene, this,
             &EnvironmentDock::update);
    update();
}

void EnvironmentDock::update() {
    const BlockValues* environment = document_.scene().part(kinds::environment);
    chooser_->show(environment ? QString::fromStdString(environment->id) : QString());
}

} // namespace patina
