// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/change_command.h"

namespace patina {

/// Gives the scene, or one of its lights, another block of a kind that is a part of it, or none.
class SceneBlockCommand : public ChangeCommand<BlockPath, std::optional<BlockValues>> {
  public:
    SceneBlockCommand(Document& document, const BlockPath& path, std::optional<BlockValues> after,
                      const QString& label);

  private:
    void apply(const std::optional<BlockValues>& values) override;
};

} // namespace patina
