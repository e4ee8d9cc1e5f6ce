// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/change_command.h"

namespace patina {

/// Notes that side A shows a material just to be looked at, or that it does no more.
class LookCommand : public ChangeCommand<int, std::optional<LookedAt>> {
  public:
    LookCommand(Document& document, std::optional<LookedAt> after);

  private:
    void apply(const std::optional<LookedAt>& lookedAt) override;
};

} // namespace patina
