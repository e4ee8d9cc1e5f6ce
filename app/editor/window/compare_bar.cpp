// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/compare_bar.h"

#include <algorithm>
#include <cmath>

#include <QComboBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

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
    makeSteps(row);
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

void CompareBar::makeSteps(QHBoxLayout* row) {
    const struct {
        const char* name;
        Qt::ArrowType arrow;
        QString toolTip;
        int by;
    } steps[] = {{"previousPreset", Qt::LeftArrow,
                  tr("Put the previous preset on B, with Shift on A (also by the arrow keys)"), -1},
                 {"nextPreset", Qt::RightArrow,
                  tr("Put the next preset on B, with Shift on A (also by the arrow keys)"), 1}};
    for (const auto& step : steps) {
        auto* button = new QToolButton(this);
        button->setObjectName(step.name);
        button->setArrowType(step.arrow);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::StrongFocus);
        button->setToolTip(step.toolTip);
        button->setAccessibleName(step.toolTip);
        connect(button, &QToolButton::clicked, this,
                [this, by = step.by] { this->step(by, QGuiApplication::keyboardModifiers()); });
        button->installEventFilter(this);
        row->addWidget(button);
    }
    count_->installEventFilter(this);
    mode_->installEventFilter(this);
}

void CompareBar::step(int by, Qt::KeyboardModifiers modifiers) {
    Q_EMIT stepWished(modifiers.testFlag(Qt::ShiftModifier) ? Side::A : Side::B, by);
}

/// Takes the arrows along the bar, and of its buttons also those across it, which change what a box
/// shows.
bool CompareBar::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) {
        return QWidget::eventFilter(watched, event);
    }
    const auto& pressed = *static_cast<QKeyEvent*>(event);
    const bool isButton = qobject_cast<QToolButton*>(watched) != nullptr;
    const int key = pressed.key();
    const bool isBack = key == Qt::Key_Left || (isButton && key == Qt::Key_Up);
    const bool isOn = key == Qt::Key_Right || (isButton && key == Qt::Key_Down);
    if (isBack || isOn) {
        step(isOn ? 1 : -1, pressed.modifiers());
        return true;
    }
    return QWidget::eventFilter(watched, event);
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
