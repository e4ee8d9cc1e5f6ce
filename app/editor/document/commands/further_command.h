// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "document/commands/change_command.h"

namespace patina {

/// Names the object that sides C and D are shown on.
struct FurtherSides {
    int object = 0;

    friend bool operator==(const FurtherSides&, const FurtherSides&) = default;
};

/// Adds sides C and D, replaces their materials, or takes them away.
class FurtherCommand : public ChangeCommand<FurtherSides, std::vector<Material>> {
  public:
    FurtherCommand(Document& document, std::vector<Material> after);

    const Material* origin(MaterialPlace& place) const override;

  private:
    void apply(const std::vector<Material>& further) override;
};

} // namespace patina
