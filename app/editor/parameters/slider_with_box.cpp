// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/slider_with_box.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QScopedValueRollback>

#include "parameters/number_box.h"
#include "parameters/scrub_label.h"
#include "parameters/value_slider.h"
#include "parameters/value_steps.h"

namespace patina {

namespace {

constexpr double scrubPixels = 300.0; // pixels from one end of the soft range to the other
constexpr int restMilliseconds = 400; // is longer than a slow key repeat

} // namespace

SliderWithBox::SliderWithBox(const Parameter& parameter, double defaultValue, const QString& name,
                             QWidget* parent)
    : QWidget(parent), parameter_(parameter), defaultValue_(defaultValue), range_(parameter),
      slider_(new ValueSlider(this)),
      box_(new NumberBox(parameter.decimals, QString::fromStdString(parameter.unit), this)) {
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(6);
    line->addWidget(slider_, 1);
    line->addWidget(box_);
    setFocusProxy(slider_);
    box_->setZeroText(QString::fromStdString(parameter.zeroText));
    slider_->setAccessibleName(name);
    box_->setAccessibleName(tr("%1, number").arg(name));
    slider_->setDefaultValue(defaultValue);
    slider_->setRange(range_);
    stepping_.setSingleShot(true);
    stepping_.setInterval(restMilliseconds);

    connect(&stepping_, &QTimer::timeout, this, &SliderWithBox::interactionEnded);
    connect(slider_, &ValueSlider::dragBegan, this, [this] {
        finishStepping();
        Q_EMIT interactionBegan();
    });
    connect(slider_, &ValueSlider::dragEnded, this, &SliderWithBox::interactionEnded);
    connect(slider_, &ValueSlider::moved, this, &SliderWithBox::ask);
    connect(slider_, &ValueSlider::jumped, this, &SliderWithBox::ask);
    connect(box_, &NumberBox::typed, this, &SliderWithBox::ask);
    connect(slider_, &ValueSlider::stepped, this, &SliderWithBox::step);
    connect(box_, &NumberBox::stepped, this, &SliderWithBox::step);
}

/// Tells whether the slider keeps its range: a handle stays under the pointer, and a number that is
/// edited here stays where it is.
bool SliderWithBox::keepsRange(double value) const {
    const bool isDefault = static_cast<float>(value) == static_cast<float>(defaultValue_);
    return slider_->isDragging() || isScrubbing_ || (!isDefault && (isAsking_ || value == value_));
}

void SliderWithBox::present(double value) {
    SliderRange range = range_;
    if (!keepsRange(value)) {
        range.reset();
    }
    value_ = value;
    range.widenFor(value);
    if (!(range == range_)) {
        range_ = range;
        slider_->setRange(range_);
    }
    slider_->setValue(value);
    box_->setValue(value);
}

void SliderWithBox::ask(double wanted) {
    if (!std::isfinite(wanted)) {
        return;
    }
    const bool isWhole = infoOf(parameter_.type).isWhole;
    const double number = isWhole ? std::round(wanted) : wanted;
    const QScopedValueRollback<bool> asking(isAsking_, true);
    Q_EMIT edited(std::clamp(number, parameter_.min, parameter_.max));
}

void SliderWithBox::step(double steps) {
    if (!stepping_.isActive()) {
        Q_EMIT interactionBegan();
    }
    stepping_.start();
    const bool isWhole = infoOf(parameter_.type).isWhole;
    const double whole =
        steps < 0.0 ? std::min(-1.0, std::round(steps)) : std::max(1.0, std::round(steps));
    ask(range_.stepped(value_, isWhole ? whole : steps));
}

void SliderWithBox::scrubWith(ScrubLabel& label) {
    label.setDraggable();
    connect(&label, &ScrubLabel::scrubBegan, this, &SliderWithBox::beginScrub);
    connect(&label, &ScrubLabel::scrubbed, this, &SliderWithBox::scrub);
    connect(&label, &ScrubLabel::scrubCancelled, this, &SliderWithBox::cancelScrub);
    connect(&label, &ScrubLabel::scrubEnded, this, &SliderWithBox::endScrub);
}

void SliderWithBox::beginScrub() {
    finishStepping();
    isScrubbing_ = true;
    scrubRange_ = range_;
    scrubStart_ = value_;
    scrubPosition_ = range_.positionOf(value_);
    Q_EMIT interactionBegan();
}

void SliderWithBox::scrub(double pixels, Qt::KeyboardModifiers modifiers) {
    const double pixel = fineness(modifiers) / scrubPixels;
    const double position = scrubPosition_ + pixels * pixel;
    if (scrubRange_.isInHardRange(position)) {
        scrubPosition_ = position; // or the way back from the end would be as long as the way there
    }
    ask(modifiers & Qt::ControlModifier ? scrubRange_.continuedSnapAt(position, snapPixels * pixel)
                                        : scrubRange_.continuedValueAt(position, pixel));
}

void SliderWithBox::cancelScrub() {
    ask(scrubStart_);
    range_ = scrubRange_;
    slider_->setRange(range_);
}

void SliderWithBox::endScrub() {
    isScrubbing_ = false;
    Q_EMIT interactionEnded();
    present(value_);
}

void SliderWithBox::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    finishStepping(); // the row may go before the keys have rested
}

void SliderWithBox::finishStepping() {
    if (stepping_.isActive()) {
        stepping_.stop();
        Q_EMIT interactionEnded();
    }
}

} // namespace patina
