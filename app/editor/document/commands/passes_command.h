// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "document/commands/change_command.h"

namespace patina {

/// Stands for the passes over the picture as a whole.
struct AllPasses {
    friend bool operator==(const AllPasses&, const AllPasses&) = default;
};

/// Changes which passes work over the picture, and in which order.
class PassesCommand : public ChangeCommand<AllPasses, std::vector<BlockValues>> {
  public:
    PassesCommand(Document& document, std::vector<BlockValues> after, const QString& label);

  private:
    void apply(const std::vector<BlockValues>& passes) override;
};

} // namespace patina
