// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <glm/vec3.hpp>

namespace patina {

/// A button that shows a linear colour as it looks on screen.
class ColorSwatch : public QAbstractButton {
    Q_OBJECT

  public:
    explicit ColorSwatch(QWidget* parent = nullptr);

    void setColor(const glm::dvec3& linear);
    QSize sizeHint() const override;

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    glm::dvec3 color_{0.0};
};

} // namespace patina
