// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/variant_changes_dialog.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include "library/thumbnail_maker.h"

namespace patina {
namespace {

constexpr int shownPixels = 128;
constexpr QSize startSize(460, 480);

} // namespace

VariantChangesDialog::VariantChangesDialog(const std::vector<VariantChange>& changes,
                                           ThumbnailMaker& thumbnails, QWidget* parent)
    : QDialog(parent) {
    setWindowTitle(tr("Changed variants"));
    resize(startSize);
    auto* list = new QWidget;
    auto* grid = new QGridLayout(list);
    grid->addWidget(new QLabel(tr("Before")), 0, 1, Qt::AlignHCenter);
    grid->addWidget(new QLabel(tr("After")), 0, 2, Qt::AlignHCenter);
    grid->setColumnStretch(0, 1);
    connect(&thumbnails, &ThumbnailMaker::ready, this,
            [this](const QString& name, const QImage& picture) {
                if (QLabel* label = pictures_.take(name); label && !picture.isNull()) {
                    label->setPixmap(QPixmap::fromImage(picture.scaled(
                        shownPixels, shownPixels, Qt::KeepAspectRatio, Qt::SmoothTransformation)));
                }
            });
    int row = 1;
    for (const VariantChange& change : changes) {
        auto* name = new QLabel(change.after->name);
        name->setWordWrap(true);
        name->setTextFormat(Qt::PlainText);
        grid->addWidget(name, row, 0);
        grid->addWidget(pictureOf(change.before, tr("%1 before"), thumbnails), row, 1);
        grid->addWidget(pictureOf(change.after, tr("%1 after"), thumbnails), row, 2);
        ++row;
    }
    grid->setRowStretch(row, 1);
    auto* area = new QScrollArea;
    area->setWidget(list);
    area->setWidgetResizable(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(area, 1);
    layout->addWidget(buttons);
}

QLabel* VariantChangesDialog::pictureOf(const PresetPtr& entry, const QString& said,
                                        ThumbnailMaker& thumbnails) {
    auto* label = new QLabel;
    label->setFixedSize(shownPixels, shownPixels);
    label->setAccessibleName(said.arg(entry->name));
    const QString name = QStringLiteral("variant/%1").arg(pictures_.size());
    pictures_[name] = label;
    thumbnails.ask(name, entry->material);
    return label;
}

} // namespace patina
