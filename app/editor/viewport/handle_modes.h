// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace patina {

/// Tells what the handles of the selected objects do.
enum class Gizmo { None, Move, Turn, Scale };

/// Knows which handles all views show.
class HandleModes : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    Gizmo gizmo() const { return gizmo_; }
    void setGizmo(Gizmo gizmo);
    bool showsLights() const { return showsLights_; }
    void setShowsLights(bool shows);

  Q_SIGNALS:
    void changed();

  private:
    Gizmo gizmo_ = Gizmo::None;
    bool showsLights_ = true;
};

} // namespace patina
