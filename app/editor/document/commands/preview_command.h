// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/change_command.h"

namespace patina {

/// Notes that side A only previews a material, or that it no longer does (nothing).
class PreviewCommand : public ChangeCommand<int, std::optional<MaterialPreview>> {
  public:
    PreviewCommand(Document& document, std::optional<MaterialPreview> after);

  private:
    void apply(const std::optional<MaterialPreview>& preview) override;
};

} // namespace patina
