// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/list_command.h"

namespace patina {

/// Adds an object, removes one or changes one as a whole: its name or mesh.
class ObjectCommand : public ListCommand<Object> {
  public:
    ObjectCommand(Document& document, int index, std::optional<Object> before,
                  std::optional<Object> after, const QString& label);

    const Material* origin(MaterialPlace& place) const override;

  private:
    std::vector<Object>& list() const override;
    void announce() const override;
    void setCurrent(int index) const override;
};

} // namespace patina
