// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "docks/dock_context.h"

class QLabel;
class QToolButton;

namespace patina {

class EnvironmentChooser;

/// Turns the scene's environment on and off, chooses its kind or a picture, takes its lamps out and
/// edits its values.
class EnvironmentDock : public QWidget {
    Q_OBJECT

  public:
    explicit EnvironmentDock(const DockContext& context);

  private:
    void update();

    Document& document_;
    EnvironmentChooser* chooser_;
    QLabel* owner_;     ///< says that the environment is a view's own; hidden if it is the scene's
    QToolButton* take_; ///< makes lights of the environment's lamps
};

} // namespace patina
