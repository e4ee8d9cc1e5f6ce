// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/material_command.h"

namespace patina {

/// Gives a material another Fresnel block, or none (null). Values are parked as for a model.
class FresnelCommand : public MaterialCommand {
  public:
    FresnelCommand(Document& document, const MaterialTarget& target, const Block* block);
};

} // namespace patina
