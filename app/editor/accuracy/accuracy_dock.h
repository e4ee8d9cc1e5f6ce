// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QTabWidget>

#include "docks/dock_context.h"
#include "docks/dock_page.h"

namespace patina {

/// Shows what accuracy costs on six pages, of which only one measures at a time: This Material and
/// This Picture chart time against error, All Models compares models, Scaling shows how time grows,
/// Match finds the models that look like something else, Cheaper Ways searches for levels that
/// nobody has declared.
class AccuracyDock : public QTabWidget {
    Q_OBJECT

  public:
    explicit AccuracyDock(const DockContext& context);

    /// Returns its tabs from left to right, which also commands open by their names.
    static std::vector<DockPage> pages();
};

} // namespace patina
