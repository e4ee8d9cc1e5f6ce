// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/material_command.h"

namespace patina {

/// Gives a material another block of a kind beside its model, or none (null). Values are parked as
/// for a model.
class PartCommand : public MaterialCommand {
  public:
    PartCommand(Document& document, const BlockPath& path, const Block* block);
};

} // namespace patina
