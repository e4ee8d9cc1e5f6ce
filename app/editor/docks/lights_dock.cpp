// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/lights_dock.h"

#include <QCheckBox>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "docks/block_chooser.h"
#include "docks/check_list.h"
#include "docks/light_actions.h"
#include "docks/panel.h"
#include "docks/part_panel.h"
#include "document/scene_edits.h"
#include "files/file_actions.h"
#include "parameters/document_form.h"
#include "text/short_text.h"

namespace patina {

LightsDock::LightsDock(const DockContext& context)
    : document_(context.document), list_(new CheckList(this)),
      add_(textButton(tr("Add"), tr("Add a light"), this)),
      remove_(textButton(tr("Remove"), tr("Remove the chosen light (Del)"), this)),
      solo_(textButton(tr("Solo"), tr("Only the chosen light; once more: those before"), this)),
      kinds_(new QMenu(this)),
      kind_(new BlockChooser(document_, kinds::lights, BlockChooser::Off::Absent, this)),
      key_(new QCheckBox(tr("&Key light"), this)),
      shadow_(new BlockChooser(document_, kinds::shadows, BlockChooser::Off::Offered, this)) {
    add_->setMenu(kinds_);
    add_->setPopupMode(QToolButton::InstantPopup);
    kind_->setToolTip(tr("Kind of the chosen light"));
    kind_->setAccessibleName(tr("Kind of light"));
    list_->setAccessibleName(tr("Lights"));
    shadow_->setAccessibleName(tr("Shadows"));
    auto* forms = new QWidget;
    auto* layout = new QVBoxLayout(forms);
    layout->setContentsMargins(0, 0, 0, 0);
    key_->setToolTip(tr("Drawings (Gooch, toon, halftone, hatching) take this light alone. Where "
                        "none is marked they take the brightest one."));
    layout->addWidget(key_);
    layout->addWidget(new DocumentForm(document_, context.textures, kinds::lights));
    layout->addWidget(labelled(tr("&Shadows"), shadow_));
    layout->addWidget(new DocumentForm(document_, context.textures, kinds::shadows));
    addPartPanels(*layout, BlockOwner::Light, document_, context.textures);
    fillPanel(this, {list_, rowOf({kind_, solo_, add_, remove_})}, forms);
    connectList(context.files);
    connect(kinds_, &QMenu::aboutToShow, this, &LightsDock::fillMenu);
    connect(kind_, &BlockChooser::chosen, this,
            [this, &meshes = context.meshes](const QString& id) {
                setKindOfLight(document_, meshes, id.toStdString());
            });
    connect(shadow_, &BlockChooser::chosen, this, [this](const QString& id) {
        document_.setBlock(document_.selection().currentPath(kinds::shadows), id.toStdString());
    });
    connect(key_, &QCheckBox::clicked, this, &LightsDock::markKey);
    connect(solo_, &QToolButton::clicked, this,
            [this] { toggleSolo(document_, document_.selection().light()); });
    connect(remove_, &QToolButton::clicked, this,
            [this] { removeLight(document_, document_.selection().light()); });
    onChange(document_, DocumentChange::Lights | DocumentChange::Current | DocumentChange::Scene,
             this, &LightsDock::update);
    onChange(document_, DocumentChange::Block, this, &LightsDock::updateShadow);
    update();
}

void LightsDock::connectList(FileActions& files) {
    for (QAction* action : (new LightActions(document_, files, this))->all()) {
        list_->addAction(action);
    }
    list_->setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(list_, &CheckList::duplicateWished, &files.clipboard(),
            &ClipboardActions::duplicateLight);
    connect(list_, &CheckList::chosen, this,
            [this](int row) { document_.selection().setLight(row); });
    connect(list_, &CheckList::switched, this, &LightsDock::switchLight, Qt::QueuedConnection);
    connect(list_, &CheckList::renamed, this, &LightsDock::renameLight, Qt::QueuedConnection);
    connect(list_, &CheckList::removeWished, this,
            [this](int row) { removeLight(document_, row); });
}

void LightsDock::fillMenu() {
    kinds_->clear();
    kinds_->setToolTipsVisible(true);
    for (const Block* light : document_.catalog().ofKind(kinds::lights)) {
        const std::string id = light->id;
        QAction* action = kinds_->addAction(shortened(QString::fromStdString(light->label)));
        action->setToolTip(blockToolTip(*light));
        connect(action, &QAction::triggered, this, [this, id] {
            addLight(document_, id);
            document_.selection().setLight(static_cast<int>(document_.scene().lights.size()) - 1);
        });
    }
}

void LightsDock::update() {
    std::vector<CheckList::Row> rows;
    for (const Light& light : document_.scene().lights) {
        const Block* block = document_.catalog().find(kinds::lights, light.block.id);
        const QString kind = QString::fromStdString(block ? block->label : light.block.id);
        rows.push_back(
            {light.name.empty() ? kind : QString::fromStdString(light.name), kind, light.enabled});
    }
    const int current = document_.selection().light();
    list_->setRows(rows, current);
    const bool any = current >= 0;
    kind_->setEnabled(any);
    remove_->setEnabled(any);
    key_->setEnabled(any);
    solo_->setEnabled(any);
    const auto& lights = document_.scene().lights;
    kind_->show(any ? QString::fromStdString(lights[static_cast<std::size_t>(current)].block.id)
                    : QString());
    key_->setChecked(any && lights[static_cast<std::size_t>(current)].isKey);
    updateShadow();
}

/// Disables the choice of shadows for kinds of light that cast none, unless one is set.
void LightsDock::updateShadow() {
    const auto index = static_cast<std::size_t>(document_.selection().light());
    const auto& lights = document_.scene().lights;
    const Light* light = index < lights.size() ? &lights[index] : nullptr;
    const Block* block = light ? document_.catalog().find(kinds::lights, light->block.id) : nullptr;
    const BlockValues* shadow = light ? light->part(kinds::shadows) : nullptr;
    shadow_->setEnabled(shadow || (block && block->shadowProjection != ShadowProjection::None));
    shadow_->show(shadow ? QString::fromStdString(shadow->id) : QString());
}

void LightsDock::switchLight(int index, bool on) {
    if (document_.scene().lights.at(static_cast<std::size_t>(index)).enabled != on) {
        toggleMute(document_, index);
    }
}

void LightsDock::markKey(bool isKey) {
    const int index = document_.selection().light();
    Light light = document_.scene().lights.at(static_cast<std::size_t>(index));
    light.isKey = isKey;
    setLight(document_, index, light);
}

void LightsDock::renameLight(int index, const QString& name) {
    Light light = document_.scene().lights.at(static_cast<std::size_t>(index));
    light.name = name.toStdString();
    setLight(document_, index, light);
}

} // namespace patina
