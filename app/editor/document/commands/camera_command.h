// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/change_command.h"

namespace patina {

/// Holds the way of the camera that belongs to another edit: framing a mesh that was dropped.
class CameraCommand : public ChangeCommand<int, Camera> {
  public:
    CameraCommand(Document& document, const Camera& before, const Camera& after);

  private:
    void apply(const Camera& camera) override;
};

} // namespace patina
