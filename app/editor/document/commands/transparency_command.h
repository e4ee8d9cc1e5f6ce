// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "document/commands/change_command.h"

namespace patina {

/// Puts what shines through together in another way.
class TransparencyCommand : public ChangeCommand<std::monostate, std::optional<BlockValues>> {
  public:
    TransparencyCommand(Document& document, std::optional<BlockValues> after, const QString& label);

  private:
    void apply(const std::optional<BlockValues>& transparency) override;
};

} // namespace patina
