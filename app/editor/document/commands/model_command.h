// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/material_command.h"

namespace patina {

/// Gives a material another lighting model: values with the same id carry over, the others are
/// parked in the material and come back with their model.
class ModelCommand : public MaterialCommand {
  public:
    ModelCommand(Document& document, const MaterialPlace& target, const Block& model);
};

} // namespace patina
