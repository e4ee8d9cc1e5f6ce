// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/slot_panel.h"

#include <QVBoxLayout>

#include "docks/block_chooser.h"
#include "docks/panel.h"
#include "document/document.h"
#include "material/model_swap.h"
#include "parameters/document_form.h"

namespace patina {

SlotPanel::SlotPanel(Document& document, TextureLibrary& textures, std::string_view kind,
                     const QString& title, QWidget* parent)
    : QGroupBox(title, parent), document_(document), kind_(kind),
      chooser_(new BlockChooser(document, kind, BlockChooser::Off::Offered, this)),
      form_(new DocumentForm(document, textures, kind)) {
    chooser_->setAccessibleName(title);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(labelled(tr("&Kind"), chooser_));
    layout->addWidget(form_);
    connect(chooser_, &BlockChooser::chosen, this, [this](const QString& id) {
        document_.setBlock(document_.selection().currentPath(kind_), id.toStdString());
    });
    onChange(document_,
             DocumentChange::Material | DocumentChange::Current | DocumentChange::Scene |
                 DocumentChange::Catalog,
             this, &SlotPanel::update);
    update();
}

void SlotPanel::update() {
    const Material* material = document_.material(document_.selection().side());
    const Block* model =
        material ? document_.catalog().find(kinds::models, material->model.id) : nullptr;
    const BlockValues* part = material ? material->part(kind_) : nullptr;
    chooser_->show(part ? QString::fromStdString(part->id) : QString());
    setVisible(model && hasPlaceFor(*model, kind_));
}

} // namespace patina
