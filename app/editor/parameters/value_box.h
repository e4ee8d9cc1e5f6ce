// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

namespace patina {

/// Tells whether an event asks a field if it takes the key for undo or redo.
bool asksForUndo(const QEvent& event);

/// Lets a value be typed into a field. Enter or leaving it asks for what was typed, Esc takes the
/// typing back; undo is the document's except while there is typing to take back.
class ValueBox : public QLineEdit {
    Q_OBJECT

  public:
    explicit ValueBox(QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

    /// Asks for what was typed, if anything was.
    virtual void commit() = 0;
    /// Shows the value as it is, whatever was typed.
    virtual void showValue() = 0;
};

} // namespace patina
