// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/part_panel.h"

#include <algorithm>

#include <QVBoxLayout>

#include "docks/block_chooser.h"
#include "docks/panel.h"
#include "document/document.h"
#include "material/model_swap.h"
#include "parameters/document_form.h"

namespace patina {
namespace {

/// Holds the kinds whose panels do more than choose a block and edit its values.
constexpr std::string_view withPanelsOfTheirOwn[] = {
    kinds::fresnel,      kinds::specular, kinds::refraction,  kinds::shadows,
    kinds::transparency, kinds::fog,      kinds::environment, kinds::tone};

} // namespace

PartPanel::PartPanel(Document& document, TextureLibrary& textures, std::string_view kind,
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
             DocumentChange::Material | DocumentChange::Block | DocumentChange::Lights |
                 DocumentChange::Current | DocumentChange::Scene | DocumentChange::Catalog,
             this, &PartPanel::update);
    update();
}

void PartPanel::update() {
    const BlockValues* part =
        blockValuesAt(document_.state(), document_.selection().currentPath(kind_));
    chooser_->show(part ? QString::fromStdString(part->id) : QString());
    setVisible(isPossible());
}

bool PartPanel::isPossible() const {
    switch (findKind(kind_)->owner) {
    case BlockOwner::Material: {
        const Material* material = document_.material(document_.selection().side());
        const Block* model =
            material ? document_.catalog().find(kinds::models, material->model.id) : nullptr;
        return model && hasPlaceFor(*model, kind_);
    }
    case BlockOwner::Light:
        return document_.selection().light() >= 0;
    default:
        return true;
    }
}

void addPartPanels(QBoxLayout& layout, BlockOwner owner, Document& document,
                   TextureLibrary& textures) {
    for (const std::string_view kind : partKinds(owner)) {
        if (std::ranges::find(withPanelsOfTheirOwn, kind) == std::end(withPanelsOfTheirOwn)) {
            const std::string_view label = findKind(kind)->label;
            layout.addWidget(new PartPanel(
                document, textures, kind,
                QString::fromUtf8(label.data(), static_cast<qsizetype>(label.size()))));
        }
    }
}

} // namespace patina
