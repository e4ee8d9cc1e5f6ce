// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <glm/vec3.hpp>

namespace patina {

/// A field for a colour as the sRGB hex number that a screen shows.
class HexBox : public QLineEdit {
    Q_OBJECT

  public:
    explicit HexBox(QWidget* parent = nullptr);

    void setColor(const glm::dvec3& linear);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  Q_SIGNALS:
    void typed(const glm::dvec3& linear);

  protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    void commit();
    void showColor();

    glm::dvec3 color_{0.0};
};

} // namespace patina
