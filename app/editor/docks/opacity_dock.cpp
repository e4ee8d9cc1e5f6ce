// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/opacity_dock.h"

#include <QGroupBox>
#include <QLabel>
#include <QVBoxLayout>

#include "docks/block_chooser.h"
#include "docks/panel.h"
#include "docks/part_panel.h"
#include "docks/refraction_panel.h"
#include "parameters/document_form.h"

namespace patina {

OpacityDock::OpacityDock(const DockContext& context)
    : document_(context.document), transparency_(new BlockChooser(document_, kinds::transparency,
                                                                  tr("Sorted by object"), this)) {
    QLabel* hint = hintLabel(this);
    hint->setText(tr("What lies over the whole surface, whatever its model."));
    transparency_->setObjectName(QStringLiteral("order"));
    transparency_->setAccessibleName(tr("Order of transparent objects"));
    transparency_->setToolTip(
        tr("<p>How objects below an opacity of 1 are put together, in the whole scene.</p>"
           "<p>Sorted by object: each is drawn over what is behind it, farthest first, and only "
           "its nearest surface is seen. That is wrong where objects cross. Objects with "
           "refraction are always sorted.</p>"));
    auto* scene = new QGroupBox(tr("Transparent objects of the scene"), this);
    auto* inScene = new QVBoxLayout(scene);
    inScene->addWidget(labelled(tr("&Order"), transparency_));
    inScene->addWidget(new DocumentForm(document_, context.textures, kinds::transparency));
    auto* forms = new QWidget;
    auto* layout = new QVBoxLayout(forms);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new DocumentForm(document_, context.textures, settings::material));
    layout->addWidget(new RefractionPanel(document_, context.textures, forms));
    addPartPanels(*layout, BlockOwner::Material, document_, context.textures);
    layout->addWidget(scene);
    layout->addStretch(1);
    fillPanel(this, {hint}, forms);
    connect(transparency_, &BlockChooser::chosen, this, [this](const QString& id) {
        document_.setBlock(pathOf(kinds::transparency), id.toStdString());
    });
    onChange(document_, DocumentChange::Block | DocumentChange::Scene, this, &OpacityDock::update);
    update();
}

void OpacityDock::update() {
    const BlockValues* chosen = document_.scene().part(kinds::transparency);
    transparency_->show(chosen ? QString::fromStdString(chosen->id) : QString());
}

} // namespace patina
