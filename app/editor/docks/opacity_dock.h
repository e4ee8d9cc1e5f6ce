// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "docks/dock_context.h"

namespace patina {

class BlockChooser;

/// The active material's opacity, which every model has, how it refracts what passes, and how the
/// scene puts together what is transparent.
class OpacityDock : public QWidget {
    Q_OBJECT

  public:
    explicit OpacityDock(const DockContext& context);

  private:
    void update();

    Document& document_;
    BlockChooser* transparency_;
};

} // namespace patina
