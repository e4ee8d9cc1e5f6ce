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
    QLabel* owner_;     ///< says whose environment it is, where it is not the scene's
    QToolButton* take_; ///< lamps out
};

} // namespace patina
