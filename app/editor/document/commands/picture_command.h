// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/change_command.h"

namespace patina {

/// Notes how finely the sides draw the picture just to be looked at, or that they do no more.
class PictureCommand : public ChangeCommand<int, std::optional<ComparedPicture>> {
  public:
    PictureCommand(Document& document, std::optional<ComparedPicture> after);

  private:
    void apply(const std::optional<ComparedPicture>& picture) override;
};

} // namespace patina
