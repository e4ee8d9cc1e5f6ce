// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/camera_command.h"

namespace patina {

CameraCommand::CameraCommand(Document& document, const Camera& before, const Camera& after)
    : ChangeCommand(document, QObject::tr("Camera"), 0, before, after) {}

void CameraCommand::apply(const Camera& camera) {
    document().setCamera(camera);
}

} // namespace patina
