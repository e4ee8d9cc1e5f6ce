// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/change_command.h"

namespace patina {

/// Unlinks settings of a side's view from the scene, changes what it has of its own, or links it
/// again.
class OwnViewCommand : public ChangeCommand<Side, OwnView> {
  public:
    OwnViewCommand(Document& document, Side side, OwnView after, const QString& label);

  private:
    void apply(const OwnView& own) override;
};

} // namespace patina
