// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/parameter_editor.h"

namespace patina {

class ColorPicker;
class ColorSwatch;
class Eyedropper;
class HexBox;

/// Represents a swatch that opens a picker, and the colour's sRGB hex.
class ColorEditor : public ParameterEditor {
    Q_OBJECT

  public:
    ColorEditor(const Parameter& parameter, QWidget* parent);

    void present(const Value& value) override;
    QWidget* focusTarget() override;

  private:
    void openPicker();
    void makePicker();
    void makeEyedropper();
    QWidget* popup() const;
    void pickFromScreen();
    void endPicking(bool taken);

    glm::dvec3 color_{0.0};
    ColorSwatch* swatch_;
    HexBox* hex_;
    ColorPicker* picker_ = nullptr; ///< made when it is first opened
    Eyedropper* eyedropper_ = nullptr; ///< likewise
    glm::dvec3 colorBefore_{0.0}; ///< what giving up the picking goes back to
};

} // namespace patina
