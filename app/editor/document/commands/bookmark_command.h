// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "document/commands/change_command.h"

namespace patina {

/// Keeps a view under a digit, in place of the one that was kept there.
class BookmarkCommand : public ChangeCommand<int, std::optional<Camera>> {
  public:
    BookmarkCommand(Document& document, int digit, const Camera& camera);

  private:
    void apply(const std::optional<Camera>& camera) override;
};

} // namespace patina
