// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

namespace patina {

/// Represents a small mark beside a value that can be pressed. The row's menu does the same from
/// the keyboard, so it takes no focus.
class RowMark : public QAbstractButton {
    Q_OBJECT

  public:
    /// Draws the mark into a square of `side` pixels whose corner is the origin.
    using Drawing = void (*)(QPainter& painter, double side, const QColor& color);

    explicit RowMark(Drawing drawing, QWidget* parent = nullptr);

    QSize sizeHint() const override;

  protected:
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    Drawing drawing_;
};

/// Draws a padlock, the mark of a locked value.
void drawPadlock(QPainter& painter, double side, const QColor& color);

/// Draws a round arrow, the mark of a changed value.
void drawResetArrow(QPainter& painter, double side, const QColor& color);

} // namespace patina
