// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "docks/dock_context.h"

class QGroupBox;

namespace patina {

/// The values of the active material's model, what fills its open slot, and its accuracy choices.
class ParametersDock : public QWidget {
    Q_OBJECT

  public:
    explicit ParametersDock(const DockContext& context);

  private:
    void update();

    Document& document_;
    QGroupBox* accuracy_;
};

} // namespace patina
