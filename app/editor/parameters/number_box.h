// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/value_box.h"
#include "parameters/value_steps.h"

namespace patina {

/// Edits one number in a field. It shows few digits and, once it is edited, all of them; what is
/// not touched is never rounded. Enter or leaving it asks for the number that was typed.
class NumberBox : public ValueBox {
    Q_OBJECT

  public:
    NumberBox(int decimals, const QString& unit, QWidget* parent = nullptr);

    /// Shows a text in place of 0 while the number is not edited; empty: shows the number.
    void setZeroText(const QString& text);
    void setValue(double value);
    double value() const { return value_; }

  Q_SIGNALS:
    void typed(double value);
    void stepped(double steps);

  protected:
    void commit() override;
    void showValue() override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

    /// Returns the text that the field shows for a value, in full while it is edited; it must read
    /// back as the value.
    virtual QString textOf(double value) const;

  private:
    void markWhetherValid();
    void updateMargins();
    bool showsZeroText() const;

    double value_ = 0.0;
    int decimals_;
    QString unit_;  ///< is the descriptor's, which typed units convert to
    QString shown_; ///< is the unit as people write it
    QString zeroText_;
    bool selectOnRelease_ = false;
    WheelSteps wheel_;
};

} // namespace patina
