// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "parameters/preview_button.h"

namespace patina {

/// Shows a linear colour as it looks on screen, on a button.
class ColorSwatch : public PreviewButton {
    Q_OBJECT

  public:
    explicit ColorSwatch(QWidget* parent = nullptr);

    void setColor(const glm::dvec3& linear);
    QSize sizeHint() const override;

  private:
    glm::dvec3 color_{0.0};
};

} // namespace patina
