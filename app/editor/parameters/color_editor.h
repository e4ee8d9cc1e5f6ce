// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/parameter_editor.h"

namespace patina {

class ColorPicker;
class ColorSwatch;
class Eyedropper;
class HexBox;

/// Edits a colour by a swatch that opens a picker, and by its sRGB hex.
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
    ColorPicker* picker_ = nullptr;    ///< is made when it is first opened
    Eyedropper* eyedropper_ = nullptr; ///< is made when it is first used
    glm::dvec3 colorBefore_{0.0};      ///< is the colour that comes back when picking is given up
};

} // namespace patina
