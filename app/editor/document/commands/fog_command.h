// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "document/commands/change_command.h"

namespace patina {

/// Turns fog on, off or into another kind.
class FogCommand : public ChangeCommand<std::monostate, std::optional<BlockValues>> {
  public:
    FogCommand(Document& document, std::optional<BlockValues> after, const QString& label);

  private:
    void apply(const std::optional<BlockValues>& fog) override;
};

} // namespace patina
