// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/change_command.h"

namespace patina {

/// Sets, replaces or ends (nothing) the picture settings that are compared.
class PictureCommand : public ChangeCommand<int, std::optional<ComparedPicture>> {
  public:
    PictureCommand(Document& document, std::optional<ComparedPicture> after);

  private:
    void apply(const std::optional<ComparedPicture>& picture) override;
};

} // namespace patina
