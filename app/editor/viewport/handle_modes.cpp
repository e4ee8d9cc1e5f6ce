// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/handle_modes.h"

namespace patina {

void HandleModes::setGizmo(Gizmo gizmo) {
    if (gizmo != gizmo_) {
        gizmo_ = gizmo;
        Q_EMIT changed();
    }
}

void HandleModes::setShowsLights(bool shows) {
    if (shows != showsLights_) {
        showsLights_ = shows;
        Q_EMIT changed();
    }
}

} // namespace patina
