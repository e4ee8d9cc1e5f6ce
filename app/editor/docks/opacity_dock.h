// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "docks/dock_context.h"

namespace patina {

class BlockChooser;

/// Edits the active material's opacity and refraction, its parts that no other dock edits, and the
/// order in which the scene's transparent objects are blended.
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
