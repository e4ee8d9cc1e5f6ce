// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/change_command.h"

namespace patina {

/// Names the light of the scene as a whole, as the target of an edit.
struct SceneLighting {
    friend bool operator==(const SceneLighting&, const SceneLighting&) = default;
};

/// Replaces the lights, the environment and whether it is fitted, the fog, the ground, the
/// background, exposure and tone curve. What is lit, where it is seen from and how exactly the rest
/// of the picture is computed stays.
class LightingCommand : public ChangeCommand<SceneLighting, Scene> {
  public:
    LightingCommand(Document& document, Scene after);
    LightingCommand(Document& document, Scene after, const QString& label);

  private:
    void apply(const Scene& lighting) override;
};

} // namespace patina
