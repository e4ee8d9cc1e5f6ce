// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QAbstractButton>

namespace patina {

/// Shows a value as a small picture on a button.
class PreviewButton : public QAbstractButton {
    Q_OBJECT

  public:
    /// Draws the value into a rectangle.
    using Painting = std::function<void(QPainter&, const QRectF&)>;

    PreviewButton(Painting painting, QWidget* parent);

    QSize sizeHint() const override;

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    Painting painting_;
};

} // namespace patina
