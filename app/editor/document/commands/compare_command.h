// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/change_command.h"

namespace patina {

/// Starts comparing with a second material on the current object, replaces it, or stops.
class CompareCommand : public ChangeCommand<int, std::optional<Material>> {
  public:
    CompareCommand(Document& document, std::optional<Material> after);

    const Material* origin(MaterialPlace& place) const override;

  private:
    void apply(const std::optional<Material>& second) override;
};

} // namespace patina
