// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/model_dock.h"

#include <QSignalBlocker>
#include <QVBoxLayout>

#include "docks/block_chooser.h"
#include "docks/picture_grid.h"
#include "document/document.h"
#include "library/thumbnail_maker.h"

namespace patina {
namespace {

constexpr int pictureSize = 72;
constexpr int summaryRestMs = 80;
const QString modelPictureGroup = QStringLiteral("model/");

} // namespace

ModelDock::ModelDock(const DockContext& context)
    : document_(context.document), thumbnails_(context.thumbnails),
      grid_(new PictureGrid(pictureSize, this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(grid_);
    grid_->setAccessibleName(tr("Lighting models"));
    connect(grid_, &PictureGrid::chosen, this,
            [this](QListWidgetItem* item) { choose(grid_->keyOf(item)); });
    grid_->setMouseTracking(true);
    rest_.setSingleShot(true);
    rest_.setInterval(summaryRestMs);
    connect(&rest_, &QTimer::timeout, this, [this] {
        Q_EMIT document_.modelApproached(document_.selection().side(), approached_.toStdString());
    });
    connect(grid_, &QListWidget::itemEntered, this, &ModelDock::approach);
    connect(grid_, &QListWidget::currentItemChanged, this, &ModelDock::approach);
    connect(grid_, &QListWidget::viewportEntered, &rest_, &QTimer::stop);
    connect(&thumbnails_, &ThumbnailMaker::ready, this,
            [this](const QString& name, const QImage& picture) {
                if (name.startsWith(modelPictureGroup)) {
                    grid_->setPicture(name.mid(modelPictureGroup.size()), picture);
                }
            });
    connect(grid_, &PictureGrid::pictureWished, this, &ModelDock::askForPicture);
    onChange(document_, DocumentChange::Catalog, this, &ModelDock::fill);
    onChange(document_, DocumentChange::Material | DocumentChange::Current | DocumentChange::Scene,
             this, &ModelDock::showCurrent);
    fill();
}

void ModelDock::fill() {
    std::vector<PictureGrid::Entry> entries;
    for (const Block* model : document_.catalog().ofKind(kinds::models)) {
        const QString id = QString::fromStdString(model->id);
        entries.push_back({id, QString::fromStdString(model->label), blockToolTip(*model)});
    }
    grid_->setEntries(entries);
    showCurrent();
}

void ModelDock::askForPicture(const QString& id) {
    if (const Block* model = document_.catalog().find(kinds::models, id.toStdString())) {
        thumbnails_.ask(modelPictureGroup + id, defaultMaterial(*model));
    }
}

void ModelDock::showCurrent() {
    const Material* material = document_.material(document_.selection().side());
    QListWidgetItem* item =
        material ? grid_->find(QString::fromStdString(material->model.id)) : nullptr;
    grid_->setEnabled(material != nullptr);
    if (item == grid_->currentItem()) {
        return;
    }
    const QSignalBlocker quiet(grid_);
    grid_->setCurrentItem(item);
    if (item) {
        grid_->scrollToItem(item);
    }
}

/// Lets the model's programs be compiled before it is chosen.
void ModelDock::approach(const QListWidgetItem* item) {
    if (item) {
        approached_ = grid_->keyOf(item);
        rest_.start();
    }
}

void ModelDock::choose(const QString& id) {
    const Material* material = document_.material(document_.selection().side());
    if (material && material->model.id != id.toStdString()) {
        rest_.stop();
        document_.setModel(document_.selection().side(), id.toStdString());
    }
}

} // namespace patina
