// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "docks/dock_context.h"

namespace patina {

/// The active material's opacity, which every model has.
class OpacityDock : public QWidget {
    Q_OBJECT

  public:
    explicit OpacityDock(const DockContext& context);
};

} // namespace patina
