// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/change_command.h"

namespace patina {

/// Moves the camera as part of another edit, such as framing a mesh that was dropped.
class CameraCommand : public ChangeCommand<int, Camera> {
  public:
    CameraCommand(Document& document, const Camera& before, const Camera& after);

  private:
    void apply(const Camera& camera) override;
};

} // namespace patina
