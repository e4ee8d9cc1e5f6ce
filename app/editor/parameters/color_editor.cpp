// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/color_editor.h"

#include <QHBoxLayout>

#include "parameters/color_picker.h"
#include "parameters/color_swatch.h"
#include "parameters/editor_factory.h"
#include "parameters/eyedropper.h"
#include "parameters/hex_box.h"

namespace patina {

ColorEditor::ColorEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent), swatch_(new ColorSwatch(this)), hex_(new HexBox(this)) {
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(6);
    line->addWidget(swatch_, 1);
    line->addWidget(hex_);
    swatch_->setAccessibleName(name());
    hex_->setAccessibleName(tr("%1, sRGB hex").arg(name()));
    connect(swatch_, &QAbstractButton::clicked, this, &ColorEditor::openPicker);
    connect(hex_, &HexBox::typed, this,
            [this](const glm::dvec3& wanted) { Q_EMIT edited(Value(wanted)); });
}

/// Returns the popup that the editor is in; null where it is in a window or a dock.
QWidget* ColorEditor::popup() const {
    return window()->windowType() == Qt::Popup ? window() : nullptr;
}

void ColorEditor::present(const Value& value) {
    if (const auto* color = std::get_if<glm::dvec3>(&value)) {
        color_ = *color;
        swatch_->setColor(*color);
        hex_->setColor(*color);
        if (picker_ && picker_->isVisible()) {
            picker_->present(*color);
        }
    }
}

void ColorEditor::makePicker() {
    picker_ = new ColorPicker(parameter(), this);
    connect(picker_, &ColorPicker::interactionBegan, this, &ParameterEditor::interactionBegan);
    connect(picker_, &ColorPicker::interactionEnded, this, &ParameterEditor::interactionEnded);
    connect(picker_, &ColorPicker::eyedropperWished, this, &ColorEditor::pickFromScreen);
    connect(picker_, &ColorPicker::edited, this,
            [this](const glm::dvec3& wanted) { Q_EMIT edited(Value(wanted)); });
}

void ColorEditor::openPicker() {
    if (!picker_) {
        makePicker();
    }
    picker_->present(color_);
    picker_->openAt(*swatch_);
}

/// Gives the eyedropper the widget that grabs the mouse and keys: where the editor is in a popup,
/// which is hidden meanwhile, the parent of that popup.
void ColorEditor::makeEyedropper() {
    eyedropper_ = new Eyedropper(popup() ? popup()->parentWidget() : swatch_);
    connect(eyedropper_, &Eyedropper::hovered, this,
            [this](const glm::dvec3& wanted) { Q_EMIT edited(Value(wanted)); });
    connect(eyedropper_, &Eyedropper::finished, this, &ColorEditor::endPicking);
}

void ColorEditor::pickFromScreen() {
    if (!eyedropper_) {
        makeEyedropper();
    }
    picker_->hide();
    if (popup()) {
        popup()->hide();
    }
    colorBefore_ = color_;
    Q_EMIT interactionBegan();
    eyedropper_->start();
}

void ColorEditor::endPicking(bool taken) {
    if (!taken) {
        Q_EMIT edited(Value(colorBefore_));
    }
    Q_EMIT interactionEnded();
    if (popup() && popup()->parentWidget()->isVisible()) {
        popup()->show();
    }
    if (swatch_->isVisible()) {
        openPicker();
    }
}

QWidget* ColorEditor::focusTarget() {
    return swatch_;
}

ParameterEditor* makeColorEditor(const Parameter& parameter, QWidget* parent) {
    return new ColorEditor(parameter, parent);
}

} // namespace patina
