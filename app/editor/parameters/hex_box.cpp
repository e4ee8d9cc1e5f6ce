// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/hex_box.h"

#include "core/color.h"

namespace patina {

HexBox::HexBox(QWidget* parent) : ValueBox(parent) {
    setMaxLength(16);
    setToolTip(tr("The colour as screens count it: sRGB hex"));
}

void HexBox::setColor(const glm::dvec3& linear) {
    color_ = linear;
    if (!(hasFocus() && isModified())) {
        showValue();
    }
}

void HexBox::showValue() {
    setText(QString::fromStdString(hexOf(color_)));
    setModified(false);
}

/// Asks for the typed colour, unless the present one has the same hex: hex is coarse and would
/// round it.
void HexBox::commit() {
    const std::string text = this->text().toStdString();
    const std::optional<glm::dvec3> typedColor = colorOfHex(text);
    const bool isNew = isModified() && typedColor && hexOf(*typedColor) != hexOf(color_);
    setModified(false);
    if (isNew) {
        Q_EMIT typed(*typedColor);
    }
    showValue();
}

} // namespace patina
