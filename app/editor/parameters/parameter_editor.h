// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "catalog/parameter.h"

namespace patina {

class ScrubLabel;

/// Shows one parameter's value and asks for changes; the document decides and the answer comes back
/// through present(). Types of parameters that are edited differently have subclasses of their own.
class ParameterEditor : public QWidget {
    Q_OBJECT

  public:
    ParameterEditor(const Parameter& parameter, QWidget* parent)
        : QWidget(parent), parameter_(parameter) {}

    const Parameter& parameter() const { return parameter_; }
    QString name() const { return QString::fromStdString(parameter_.label); }

    virtual void present(const Value& value) = 0;

    /// Returns what takes the focus when the row's label is activated.
    virtual QWidget* focusTarget() = 0;

    /// Lets the row's label change the value by dragging, where there is one number to change.
    virtual void scrubWith(ScrubLabel&) {}

  Q_SIGNALS:
    void interactionBegan();
    void edited(const patina::Value& value);
    void interactionEnded();

  private:
    Parameter parameter_;
};

} // namespace patina
