// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QElapsedTimer>
#include <QWidget>

#include "docks/dock_context.h"
#include "parameters/parameter_form.h"

class QGroupBox;
class QToolButton;

namespace patina {

class NoticeBar;

/// Edits the values of the active material's model, the block in its specular slot and its accuracy
/// choices; filters the rows, and offers the actions on the material.
class ParametersDock : public QWidget {
    Q_OBJECT

  public:
    explicit ParametersDock(const DockContext& context);

    void setFilter(RowFilter filter);
    /// Returns the button that shows the original: a short press toggles it, a long one shows it
    /// until the button is released.

  private:
    QWidget* filterBox();
    void connectOriginal();
    void update();
    void showNotice();

    Document& document_;
    MaterialActions& material_;
    QToolButton* original_;
    NoticeBar* notice_;
    std::vector<ParameterForm*> forms_;
    QGroupBox* accuracy_;
    QElapsedTimer held_;
    bool wasOriginal_ = false; ///< tells whether the original was shown when the button was pressed
};

} // namespace patina
