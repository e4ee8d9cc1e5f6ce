// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QFrame>
#include <QTimer>

#include "catalog/parameter.h"

class QLabel;

namespace patina {

class HexBox;
class HueStrip;
class SliderWithBox;
class SaturationField;

/// Edits a colour live in a popup: hue, saturation and brightness as a screen shows them, and the
/// linear numbers the shader gets.
class ColorPicker : public QFrame {
    Q_OBJECT

  public:
    /// `parameter` is the colour's; its range holds for each component.
    ColorPicker(const Parameter& parameter, QWidget* parent);

    void present(const glm::dvec3& linear);
    /// Opens below `anchor`, inside the screen.
    void openAt(const QWidget& anchor);

  Q_SIGNALS:
    void interactionBegan();
    void edited(const glm::dvec3& linear);
    void interactionEnded();
    /// The user wants to take a colour from the screen, without the popup in the way.
    void eyedropperWished();

  protected:
    void hideEvent(QHideEvent* event) override;

  private:
    QWidget* makeNumbers(const Parameter& parameter);
    void connectArea(class ColorArea* area);
    void askForScreenColor();
    void showScreenColor();

    glm::dvec3 color_{0.0};
    double hue_ = 0.0; ///< is kept while the colour is grey, which has no hue
    double saturation_ = 0.0;
    double brightness_ = 0.0;
    /// Holds the largest component of a colour brighter than the screen, else 1.
    double intensity_ = 1.0;
    bool isAreaDragged_ = false;
    SaturationField* field_;
    HueStrip* strip_;
    std::array<SliderWithBox*, 3> numbers_{};
    HexBox* hex_;
    QLabel* intensityLabel_;
    QTimer nudging_; ///< arrow keys in a field are one interaction until they rest
};

} // namespace patina
