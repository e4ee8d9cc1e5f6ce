// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/environment_dock.h"

#include <QLabel>
#include <QToolButton>

#include "docks/environment_chooser.h"
#include "docks/lamp_taking.h"
#include "docks/panel.h"
#include "document/scene_edits.h"
#include "parameters/document_form.h"
#include "resources/environment_library.h"
#include "viewport/side_view.h"

namespace patina {

EnvironmentDock::EnvironmentDock(const DockContext& context)
    : document_(context.document),
      chooser_(new EnvironmentChooser(document_, context.session, context.thumbnails, this)),
      owner_(hintLabel(this)),
      take_(textButton(tr("Take Lamps Out"),
                       tr("Make lights with shadows of the sun and the lamps in the environment"),
                       this)) {
    chooser_->setAccessibleName(tr("Kind of environment"));
    take_->setObjectName("takeLampsOut");
    owner_->hide();
    QLabel* hint = hintLabel(this);
    hint->setText(tr("Drop an .hdr or .exr panorama here or on the view to light the scene with "
                     "it. Its light adds to that of the lights. Shift+right drag in a view turns "
                     "it."));
    fillPanel(this, {owner_, labelled(tr("&Kind"), chooser_), hint, take_},
              new DocumentForm(document_, context.textures, kinds::environment));
    connect(chooser_, &BlockChooser::chosen, this, [this](const QString& id) {
        if (id.isEmpty() || document_.catalog().find(kinds::environment, id.toStdString())) {
            document_.setBlock(document_.selection().currentPath(kinds::environment),
                               id.toStdString());
        }
    });
    connect(chooser_, &EnvironmentChooser::pictureChosen, this,
            [this](const QString& file) { setEnvironmentPicture(document_, file.toStdString()); });
    connect(&context.environments, &EnvironmentLibrary::loaded, chooser_, &EnvironmentChooser::add);
    connect(take_, &QToolButton::clicked, this,
            [context] { takeLampsOut(context.document, context.views, context.messages); });
    onChange(document_,
             DocumentChange::Block | DocumentChange::Scene | DocumentChange::Value |
                 DocumentChange::OwnView | DocumentChange::Comparing | DocumentChange::Current,
             this, &EnvironmentDock::update);
    update();
}

void EnvironmentDock::update() {
    const bool isOfView = document_.selection().currentPath(kinds::environment).isOfView;
    owner_->setText(tr("Of view %1 alone").arg(letterOf(document_.selection().side())));
    owner_->setVisible(isOfView);
    chooser_->showCurrent();
    take_->setEnabled(!isOfView && document_.scene().part(kinds::environment) != nullptr);
}

} // namespace patina
