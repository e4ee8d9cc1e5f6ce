// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/snapshots_dock.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "document/snapshot_edits.h"
#include "text/png.h"
#include "viewport/compare_area.h"

namespace patina {
namespace {

constexpr int snapshotEdge = 96; ///< pixels, width and height of an image

/// Returns the square in the middle of a view, scaled down, as PNG.
std::string smallPicture(Viewport& view) {
    const QImage whole = view.grabPicture();
    const int edge = std::min(whole.width(), whole.height());
    const QImage square =
        whole.copy((whole.width() - edge) / 2, (whole.height() - edge) / 2, edge, edge)
            .scaled(snapshotEdge, snapshotEdge, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    return asPng(square.convertToFormat(QImage::Format_RGB888)).toStdString();
}

QIcon pictureOf(const Snapshot& snapshot) {
    QPixmap picture;
    picture.loadFromData(QByteArray::fromStdString(snapshot.png), "PNG");
    return picture;
}

QPushButton* snapshotButton(const QString& text, const QString& toolTip, QWidget* parent) {
    auto* button = new QPushButton(text, parent);
    button->setToolTip(toolTip);
    return button;
}

} // namespace

SnapshotsDock::SnapshotsDock(const DockContext& context)
    : document_(context.document), views_(context.views), list_(new QListWidget(this)),
      take_(snapshotButton(tr("Take"), tr("Keep what the active side shows (Ctrl+T)"), this)),
      restore_(snapshotButton(tr("Restore"), tr("Give the active side this look again"), this)),
      compare_(snapshotButton(tr("Compare"), tr("Put this look on side B"), this)),
      remove_(snapshotButton(tr("Remove"), tr("Forget this look"), this)) {
    layOut();
    connectParts();
    fill();
}

void SnapshotsDock::layOut() {
    list_->setObjectName("snapshots");
    list_->setAccessibleName(tr("Snapshots"));
    list_->setViewMode(QListView::IconMode);
    list_->setMovement(QListView::Static);
    list_->setResizeMode(QListView::Adjust);
    list_->setIconSize({snapshotEdge, snapshotEdge});
    list_->setWordWrap(true);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::SelectedClicked);
    auto* upper = new QHBoxLayout;
    upper->addWidget(take_);
    upper->addWidget(restore_);
    auto* lower = new QHBoxLayout;
    lower->addWidget(compare_);
    lower->addWidget(remove_);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(upper);
    layout->addLayout(lower);
    layout->addWidget(list_, 1);
}

void SnapshotsDock::connectParts() {
    const auto onCurrent = [this](void (*edit)(Document&, std::size_t)) {
        return [this, edit] {
            if (list_->currentRow() >= 0) {
                edit(document_, static_cast<std::size_t>(list_->currentRow()));
            }
        };
    };
    connect(take_, &QPushButton::clicked, this, &SnapshotsDock::take);
    connect(restore_, &QPushButton::clicked, this, onCurrent(restoreSnapshot));
    connect(compare_, &QPushButton::clicked, this, onCurrent(compareWithSnapshot));
    connect(remove_, &QPushButton::clicked, this, onCurrent(removeSnapshot));
    connect(list_, &QListWidget::itemActivated, this, onCurrent(restoreSnapshot));
    connect(list_, &QListWidget::currentRowChanged, this, &SnapshotsDock::followCurrent);
    connect(list_, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        if (!isFilling_) {
            renameSnapshot(document_, static_cast<std::size_t>(list_->row(item)),
                           item->text().toStdString());
        }
    });
    onChange(document_, DocumentChange::Snapshots | DocumentChange::Scene, this,
             &SnapshotsDock::fill);
}

void SnapshotsDock::take() {
    takeSnapshot(document_, smallPicture(views_.active().viewport()));
    list_->setCurrentRow(list_->count() - 1);
}

void SnapshotsDock::fill() {
    const int current = list_->currentRow();
    isFilling_ = true;
    list_->clear();
    for (const Snapshot& snapshot : document_.state().snapshots) {
        auto* item =
            new QListWidgetItem(pictureOf(snapshot), QString::fromStdString(snapshot.name), list_);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    isFilling_ = false;
    list_->setCurrentRow(std::min(current, list_->count() - 1));
    followCurrent();
}

void SnapshotsDock::followCurrent() {
    for (QPushButton* button : {restore_, compare_, remove_}) {
        button->setEnabled(list_->currentRow() >= 0);
    }
}

} // namespace patina
