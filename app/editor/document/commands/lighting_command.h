// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/change_command.h"

namespace patina {

/// The scene as a whole, but for its objects and its camera.
struct SceneLighting {
    friend bool operator==(const SceneLighting&, const SceneLighting&) = default;
};

/// Replaces the lights, the environment, the fog, the ground, the background, and how the picture
/// is exposed and computed. What is lit and where it is seen from stays.
class LightingCommand : public ChangeCommand<SceneLighting, Scene> {
  public:
    LightingCommand(Document& document, Scene after);

  private:
    void apply(const Scene& lighting) override;
};

} // namespace patina
