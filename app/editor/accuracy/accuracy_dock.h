// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTabWidget>

#include "docks/dock_context.h"

namespace patina {

/// Shows what accuracy costs, on four pages, of which one measures at a time: the ways to compute
/// the active material and to draw the picture, all models beside each other, and how the time
/// grows.
class AccuracyDock : public QTabWidget {
    Q_OBJECT

  public:
    explicit AccuracyDock(const DockContext& context);
};

} // namespace patina
