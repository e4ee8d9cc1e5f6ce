// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "document/commands/parameter_command.h"

namespace patina {

/// Lays an image on a value, changes how it lies there, or takes it away (none).
class TextureCommand : public ChangeCommand<ParameterTarget, std::optional<TextureUse>> {
  public:
    /// The material of the path must exist.
    TextureCommand(Document& document, const ParameterTarget& target,
                   const std::optional<TextureUse>& after, const QString& label);

  private:
    void apply(const std::optional<TextureUse>& use) override;
};

} // namespace patina
