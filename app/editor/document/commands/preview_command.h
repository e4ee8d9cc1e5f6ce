// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/change_command.h"

namespace patina {

/// Notes that side A shows a material just to be looked at, or that it does no more.
class PreviewCommand : public ChangeCommand<int, std::optional<MaterialPreview>> {
  public:
    PreviewCommand(Document& document, std::optional<MaterialPreview> after);

  private:
    void apply(const std::optional<MaterialPreview>& preview) override;
};

} // namespace patina
