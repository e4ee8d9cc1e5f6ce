// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/list_command.h"

namespace patina {

/// Adds a light, removes one or changes one as a whole: its name, whether it is on, its kind.
class LightCommand : public ListCommand<Light> {
  public:
    LightCommand(Document& document, int index, std::optional<Light> before,
                 std::optional<Light> after, const QString& label);

  private:
    std::vector<Light>& list() const override;
    void announce() const override;
    void setCurrent(int index) const override;
};

} // namespace patina
