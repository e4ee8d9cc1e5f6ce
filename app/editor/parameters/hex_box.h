// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "parameters/value_box.h"

namespace patina {

/// Edits a colour as the sRGB hex number that a screen shows.
class HexBox : public ValueBox {
    Q_OBJECT

  public:
    explicit HexBox(QWidget* parent = nullptr);

    void setColor(const glm::dvec3& linear);

  Q_SIGNALS:
    void typed(const glm::dvec3& linear);

  protected:
    void commit() override;
    void showValue() override;

  private:
    glm::dvec3 color_{0.0};
};

} // namespace patina
