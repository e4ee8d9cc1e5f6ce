// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "docks/dock_context.h"

class QLabel;

namespace patina {

class BlockChooser;

/// Turns the active material's Fresnel block on and off, chooses its kind and edits its values.
class FresnelDock : public QWidget {
    Q_OBJECT

  public:
    explicit FresnelDock(const DockContext& context);

  private:
    void update();

    Document& document_;
    BlockChooser* chooser_;
    QLabel* hint_;
};

} // namespace patina
