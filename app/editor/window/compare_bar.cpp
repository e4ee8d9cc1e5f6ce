// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/compare_bar.h"

#include <algorithm>
#include <cmath>

#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>

#include "document/comparison.h"
#include "viewport/compare_area.h"

namespace patina {
namespace {

constexpr int amountSteps = 200;
constexpr int amountWidth = 110;

} // namespace

CompareBar::CompareBar(Document& document, Comparison& comparison, CompareArea& views,
                       QWidget* parent)
    : QWidget(parent), views_(views), count_(new QComboBox(this)), mode_(new QComboBox(this)),
      amount_(new QSlider(Qt::Horizontal, this)) {
    count_->setObjectName("compareCount");
    count_->setAccessibleName(tr("How many views are compared"));
    count_->setToolTip(count_->accessibleName());
    for (std::size_t count = 2; count <= sides.size(); ++count) {
        count_->addItem(tr("%1 views").arg(count));
    }
    mode_->setObjectName("compareMode");
    mode_->setAccessibleName(tr("How A and B are shown together"));
    for (const CompareModeRow& row : compareModes()) {
        mode_->addItem(row.shownLabel());
        mode_->setItemData(mode_->count() - 1, row.shownDoc(), Qt::ToolTipRole);
    }
    amount_->setObjectName("compareAmount");
    amount_->setRange(0, amountSteps);
    amount_->setFixedWidth(amountWidth);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 0, 4, 0);
    row->addWidget(count_);
    row->addWidget(mode_);
    row->addWidget(amount_);
    connect(count_, &QComboBox::activated, this, [&comparison](int index) {
        comparison.setSideCount(static_cast<std::size_t>(index) + 2);
    });
    connect(mode_, &QComboBox::activated, this, [this](int index) {
        CompareLook look = views_.look();
        look.mode = compareModes()[static_cast<std::size_t>(index)].mode;
        views_.setLook(look);
        views_.active().viewport().setFocus(); // the keys of the mode go there
    });
    connect(amount_, &QSlider::valueChanged, this, [this](int step) {
        views_.setLook(withAmount(views_.look(), double(step) / amountSteps));
    });
    connect(&views, &CompareArea::lookChanged, this, &CompareBar::showLook);
    const auto follow = [this, &document] {
        setEnabled(document.isComparing());
        count_->setCurrentIndex(std::max(static_cast<int>(document.shownSides()) - 2, 0));
    };
    onChange(document, DocumentChange::Comparing, this, follow);
    follow();
    showLook(views.look());
}

void CompareBar::showLook(const CompareLook& look) {
    const CompareModeRow& row = rowOf(look.mode);
    const QSignalBlocker quiet(amount_);
    mode_->setCurrentIndex(static_cast<int>(&row - compareModes().data()));
    mode_->setToolTip(row.shownDoc());
    amount_->setEnabled(row.amount != nullptr);
    amount_->setValue(static_cast<int>(std::lround(amountSteps * amountOf(look))));
    amount_->setAccessibleName(row.shownAmountLabel());
    amount_->setToolTip(row.shownAmountLabel());
}

} // namespace patina
