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

/// The values of the active material's model, what fills its open slot, and its accuracy choices;
/// which of them are shown, and what can be done to the material as a whole.
class ParametersDock : public QWidget {
    Q_OBJECT

  public:
    explicit ParametersDock(const DockContext& context);

    void setFilter(RowFilter filter);
    /// Pressed for a moment it toggles, held it shows the original for as long.
    QToolButton* originalButton() const { return original_; }

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
    bool wasOriginal_ = false; ///< when the button was pressed
};

} // namespace patina
