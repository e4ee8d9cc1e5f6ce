// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/color_picker.h"

#include <algorithm>

#include <QColor>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/color.h"
#include "parameters/color_fields.h"
#include "parameters/hex_box.h"
#include "parameters/slider_with_box.h"
#include "parameters/number_format.h"
#include "parameters/popup_place.h"
#include "parameters/scrub_label.h"
#include "parameters/value_slider.h"

namespace patina {

namespace {

constexpr int restMilliseconds = 400; // is longer than a slow key repeat

Parameter componentOf(const Parameter& color) {
    Parameter component = color;
    component.type = ParameterType::Float;
    component.decimals = 4;
    return component;
}

QLabel* heading(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    return label;
}

} // namespace

ColorPicker::ColorPicker(const Parameter& parameter, QWidget* parent)
    : QFrame(parent, Qt::Popup), field_(new SaturationField(this)), strip_(new HueStrip(this)),
      hex_(new HexBox(this)), intensityLabel_(new QLabel(this)) {
    setFrameShape(QFrame::StyledPanel);
    setAccessibleName(tr("Colour picker for %1").arg(QString::fromStdString(parameter.label)));
    auto* column = new QVBoxLayout(this);
    column->addWidget(heading(QString::fromStdString(parameter.label), this));
    column->addWidget(field_);
    column->addWidget(strip_);
    column->addWidget(intensityLabel_);
    column->addWidget(makeNumbers(parameter));
    nudging_.setSingleShot(true);
    nudging_.setInterval(restMilliseconds);
    connect(&nudging_, &QTimer::timeout, this, &ColorPicker::interactionEnded);
    connectArea(field_);
    connectArea(strip_);
    connect(field_, &ColorArea::moved, this, [this](const QPointF& point) {
        saturation_ = point.x();
        brightness_ = point.y();
        askForScreenColor();
    });
    connect(strip_, &ColorArea::moved, this, [this](const QPointF& point) {
        hue_ = point.x();
        askForScreenColor();
    });
    connect(hex_, &HexBox::typed, this, &ColorPicker::edited);
}

QWidget* ColorPicker::makeNumbers(const Parameter& parameter) {
    auto* panel = new QWidget(this);
    auto* form = new QFormLayout(panel);
    form->setContentsMargins(0, 4, 0, 0);
    const Parameter component = componentOf(parameter);
    const glm::dvec3 defaults = std::get<glm::dvec3>(parameter.defaultValue);
    const std::array<QString, 3> names{tr("Linear red"), tr("Linear green"), tr("Linear blue")};
    for (int i = 0; i < 3; ++i) {
        const auto place = static_cast<std::size_t>(i);
        auto* number = new SliderWithBox(component, defaults[i], names[place], panel);
        numbers_[place] = number;
        auto* label = new ScrubLabel(names[place], panel);
        label->setBuddy(number->slider());
        number->scrubWith(*label);
        form->addRow(label, number);
        connect(number, &SliderWithBox::interactionBegan, this, &ColorPicker::interactionBegan);
        connect(number, &SliderWithBox::interactionEnded, this, &ColorPicker::interactionEnded);
        connect(number, &SliderWithBox::edited, this, [this, i](double wanted) {
            glm::dvec3 changed = color_;
            changed[i] = wanted;
            Q_EMIT edited(changed);
        });
    }
    form->addRow(tr("sRGB hex"), hex_);
    auto* pick = new QPushButton(tr("&Pick from the picture or the screen"), panel);
    pick->setToolTip(tr("Click where the colour is; Esc gives up. In a view it is the light before "
                        "exposure and tone mapping."));
    form->addRow(pick);
    connect(pick, &QPushButton::clicked, this, &ColorPicker::eyedropperWished);
    return panel;
}

void ColorPicker::connectArea(ColorArea* area) {
    connect(area, &ColorArea::dragBegan, this, [this] {
        nudging_.stop();
        isAreaDragged_ = true;
        Q_EMIT interactionBegan();
    });
    connect(area, &ColorArea::dragEnded, this, [this] {
        isAreaDragged_ = false;
        Q_EMIT interactionEnded();
    });
}

/// Asks for the colour that the fields show. A colour brighter than the screen keeps its intensity.
void ColorPicker::askForScreenColor() {
    if (!isAreaDragged_) {
        if (!nudging_.isActive()) {
            Q_EMIT interactionBegan();
        }
        nudging_.start();
    }
    const QColor shown = QColor::fromHsvF(static_cast<float>(hue_), static_cast<float>(saturation_),
                                          static_cast<float>(brightness_));
    const glm::dvec3 encoded(shown.redF(), shown.greenF(), shown.blueF());
    Q_EMIT edited(srgbDecoded(encoded) * intensity_);
}

void ColorPicker::present(const glm::dvec3& linear) {
    color_ = linear;
    for (int i = 0; i < 3; ++i) {
        numbers_[static_cast<std::size_t>(i)]->present(linear[i]);
    }
    hex_->setColor(linear);
    if (!isAreaDragged_ && !nudging_.isActive()) {
        const double peak = std::max({linear.x, linear.y, linear.z});
        intensity_ = std::max(1.0, peak);
        const glm::dvec3 encoded = srgbEncoded(linear / intensity_);
        const QColor shown =
            QColor::fromRgbF(static_cast<float>(encoded.x), static_cast<float>(encoded.y),
                             static_cast<float>(encoded.z));
        hue_ = shown.hsvHueF() < 0.0f ? hue_ : static_cast<double>(shown.hsvHueF());
        brightness_ = static_cast<double>(shown.valueF());
        saturation_ = brightness_ > 0.0 ? static_cast<double>(shown.hsvSaturationF()) : saturation_;
    }
    showScreenColor();
}

void ColorPicker::showScreenColor() {
    field_->setHue(hue_);
    field_->setPoint({saturation_, brightness_});
    strip_->setPoint({hue_, 0.5});
    intensityLabel_->setVisible(intensity_ > 1.0);
    intensityLabel_->setText(tr("Brighter than the screen: shown divided by %1")
                                 .arg(QString::fromStdString(shownNumber(intensity_, 2))));
}

void ColorPicker::hideEvent(QHideEvent* event) {
    QFrame::hideEvent(event);
    isAreaDragged_ = false;
    nudging_.stop();
    Q_EMIT interactionEnded();
}

void ColorPicker::openAt(const QWidget& anchor) {
    openBeside(*this, anchor);
    field_->setFocus();
}

} // namespace patina
