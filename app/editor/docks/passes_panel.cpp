// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/passes_panel.h"

#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "docks/block_chooser.h"
#include "docks/panel.h"
#include "document/document.h"
#include "document/scene_edits.h"
#include "parameters/document_form.h"
#include "text/short_text.h"

namespace patina {

PassesPanel::PassesPanel(Document& document, TextureLibrary& textures, QWidget* parent)
    : QWidget(parent), document_(document), textures_(textures), blocks_(new QMenu(this)),
      entries_(new QVBoxLayout) {
    auto* add = textButton(tr("Add"), tr("Add a picture pass"), this);
    add->setMenu(blocks_);
    add->setPopupMode(QToolButton::InstantPopup);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(rowOf({new QLabel(tr("Over the picture, in order"), this), add}));
    layout->addLayout(entries_);
    connect(blocks_, &QMenu::aboutToShow, this, &PassesPanel::fillMenu);
    onChange(document_, DocumentChange::Block | DocumentChange::Scene | DocumentChange::Catalog,
             this, &PassesPanel::update);
    update();
}

void PassesPanel::fillMenu() {
    blocks_->clear();
    blocks_->setToolTipsVisible(true);
    for (const Block* block : document_.catalog().ofKind(kinds::pass)) {
        const std::string id = block->id;
        QAction* action = blocks_->addAction(shortened(QString::fromStdString(block->label)));
        action->setToolTip(blockToolTip(*block));
        connect(action, &QAction::triggered, this, [this, id] { addPass(document_, id); });
    }
}

/// Entries stay while the passes are the same ones, since a slider of theirs may be held.
void PassesPanel::update() {
    std::vector<std::string> ids;
    for (const BlockValues& pass : document_.scene().passes) {
        ids.push_back(pass.id);
    }
    if (ids == shown_) {
        return;
    }
    shown_ = std::move(ids);
    while (QLayoutItem* item = entries_->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
    for (int i = 0; i < static_cast<int>(shown_.size()); ++i) {
        entries_->addWidget(entry(i, static_cast<int>(shown_.size())));
    }
}

QWidget* PassesPanel::entry(int index, int count) {
    auto* box = new QWidget(this);
    const std::string& id = shown_[static_cast<std::size_t>(index)];
    const Block* block = document_.catalog().find(kinds::pass, id);
    const QString name = QString::fromStdString(block ? block->label : id);
    auto* title = new QLabel(tr("%1. %2").arg(index + 1).arg(name), box);
    auto* up = textButton(tr("Up"), tr("Move %1 before the pass above").arg(name), box);
    auto* down = textButton(tr("Down"), tr("Move %1 behind the pass below").arg(name), box);
    auto* remove = textButton(tr("Remove"), tr("Remove %1").arg(name), box);
    up->setEnabled(index > 0);
    down->setEnabled(index + 1 < count);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(rowOf({title, up, down, remove}));
    BlockPath path = pathOf(kinds::pass);
    path.index = index;
    layout->addWidget(new DocumentForm(document_, textures_, path));
    connect(up, &QToolButton::clicked, this,
            [this, index] { movePass(document_, index, index - 1); });
    connect(down, &QToolButton::clicked, this,
            [this, index] { movePass(document_, index, index + 1); });
    connect(remove, &QToolButton::clicked, this, [this, index] { removePass(document_, index); });
    return box;
}

} // namespace patina
