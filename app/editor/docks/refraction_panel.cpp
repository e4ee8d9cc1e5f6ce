// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/refraction_panel.h"

#include <QLabel>
#include <QVBoxLayout>

#include "docks/block_chooser.h"
#include "docks/panel.h"
#include "document/document.h"
#include "parameters/document_form.h"
#include "shading/effects/refraction.h"

namespace patina {

RefractionPanel::RefractionPanel(Document& document, TextureLibrary& textures, QWidget* parent)
    : QGroupBox(tr("Refraction"), parent), document_(document),
      chooser_(new BlockChooser(document, kinds::refraction, tr("None: straight through"), this)),
      hint_(hintLabel(this)) {
    chooser_->setAccessibleName(tr("Kind of refraction"));
    hint_->setObjectName(QStringLiteral("hint"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(labelled(tr("Refracts ligh&t as"), chooser_));
    layout->addWidget(hint_);
    layout->addWidget(new DocumentForm(document_, textures, kinds::refraction));
    connect(chooser_, &BlockChooser::chosen, this, [this](const QString& id) {
        document_.setBlock(document_.selection().currentPath(kinds::refraction), id.toStdString());
    });
    onChange(document_,
             DocumentChange::Material | DocumentChange::Value | DocumentChange::Current |
                 DocumentChange::Scene | DocumentChange::Catalog,
             this, &RefractionPanel::update);
    update();
}

/// Shows why a refraction that is chosen has no effect, where that is so, or else what its block
/// says of itself: how it bends light, and what it cannot follow.
void RefractionPanel::update() {
    const Material* material = document_.material(document_.selection().side());
    const BlockValues* part = material ? material->part(kinds::refraction) : nullptr;
    chooser_->setEnabled(material != nullptr);
    chooser_->show(part ? QString::fromStdString(part->id) : QString());
    const RefractionChoice choice =
        part ? refractionChoice(*material, document_.catalog()) : RefractionChoice();
    hint_->setText(choice.block ? QString::fromStdString(choice.block->summary)
                                : QString::fromUtf8(choice.whyNot));
    hint_->setVisible(!hint_->text().isEmpty());
}

} // namespace patina
