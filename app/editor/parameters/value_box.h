// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

namespace patina {

/// Tells whether a field is asked if a key for undo or redo is its own.
bool asksForUndo(const QEvent& event);

/// Represents a field in which a value is typed. Enter or leaving it asks for what was typed, Esc
/// takes the typing back; undo is the document's except while there is typing to take back.
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
