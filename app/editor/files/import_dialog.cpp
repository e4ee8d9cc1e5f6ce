// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/import_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include "scene/scene_limits.h"
#include "text/display_number.h"
#include "text/short_text.h"

namespace patina {
namespace {

constexpr int scaleDecimals = 6;

/// Shows no more decimals than there are.
class ScaleBox : public QDoubleSpinBox {
  public:
    using QDoubleSpinBox::QDoubleSpinBox;

    QString textFromValue(double value) const override {
        return locale().toString(value, 'f', QLocale::FloatingPointShortest);
    }
};

} // namespace

ImportDialog::ImportDialog(const QString& file, const MeshImport& import, QWidget* parent)
    : QDialog(parent), fits_(new QCheckBox(tr("&Fit into a unit box"), this)),
      scale_(new ScaleBox(this)), up_(new QComboBox(this)),
      flips_(new QCheckBox(tr("Flip &normals"), this)),
      joins_(new QCheckBox(tr("&Join into one object"), this)) {
    setObjectName("import");
    setWindowTitle(tr("Import %1").arg(shortened(QFileInfo(file).fileName())));
    fits_->setChecked(import.fits);
    fits_->setToolTip(tr("Centre it, and make its longest side two metres, before the scale"));
    scale_->setLocale(numberLocale());
    scale_->setDecimals(scaleDecimals);
    scale_->setRange(smallestScale, largestScale);
    scale_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    scale_->setValue(import.scale);
    scale_->setToolTip(tr("Metres of one unit of the file: 0.01 for centimetres, 0.001 for "
                          "millimetres"));
    up_->addItems({tr("y is up"), tr("z is up")});
    up_->setCurrentIndex(import.isZUp ? 1 : 0);
    up_->setToolTip(tr("Which axis points up in the file"));
    flips_->setChecked(import.flips);
    flips_->setToolTip(tr("For meshes whose surfaces point inwards and look black"));
    joins_->setChecked(import.joins);
    joins_->setToolTip(tr("One object with the current material. Otherwise each material of the "
                          "file is an object that looks as the file says."));
    auto* hint = new QLabel(tr("With Shift held the last choices are taken without asking."), this);
    hint->setForegroundRole(QPalette::PlaceholderText);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Import"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QFormLayout(this);
    layout->addRow(fits_);
    layout->addRow(tr("&Scale"), scale_);
    layout->addRow(tr("&Axes"), up_);
    layout->addRow(flips_);
    layout->addRow(joins_);
    layout->addRow(hint);
    layout->addRow(buttons);
}

MeshImport ImportDialog::chosen() const {
    return {fits_->isChecked(), scale_->value(), flips_->isChecked(), up_->currentIndex() == 1,
            joins_->isChecked()};
}

} // namespace patina
