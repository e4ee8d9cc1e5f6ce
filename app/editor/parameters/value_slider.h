// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "parameters/slider_range.h"
#include "parameters/value_steps.h"

namespace patina {

/// Edits a real value with a slider. It shows what it is told and asks for changes: dragging moves
/// (Shift: ten times finer, Ctrl: in round steps), Esc takes a drag back, keys and the wheel step.
class ValueSlider : public QWidget {
    Q_OBJECT

  public:
    explicit ValueSlider(QWidget* parent = nullptr);

    void setRange(const SliderRange& range);
    const SliderRange& range() const { return range_; }
    void setValue(double value);
    double value() const { return value_; }
    void setDefaultValue(double value);
    bool isDragging() const { return isDragging_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  Q_SIGNALS:
    void dragBegan();
    void moved(double value);
    void dragEnded();
    /// Asks for a change by this many steps.
    void stepped(double steps);
    /// Asks for an end of the soft range.
    void jumped(double value);

  protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    double radius() const;
    double length() const;
    double pixelOf(double value) const;
    double shareAt(double pixel) const;
    void moveTo(double share, Qt::KeyboardModifiers modifiers);
    void finishDrag();
    bool cancelDrag();
    void announceValue();

    SliderRange range_;
    double value_ = 0.0;
    double defaultValue_ = 0.0;
    bool isDragging_ = false;
    double startValue_ = 0.0; ///< is the value that Esc goes back to
    double share_ = 0.0;      ///< is the position of the drag, not rounded to what was asked for
    double lastPixel_ = 0.0;
    WheelSteps wheel_;
};

} // namespace patina
