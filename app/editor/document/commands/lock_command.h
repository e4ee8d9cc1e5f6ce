// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "document/commands/change_command.h"

namespace patina {

/// Names the block whose locks an edit changes.
struct BlockLocks {
    BlockPath path;

    friend bool operator==(const BlockLocks&, const BlockLocks&) = default;
};

/// Locks or unlocks values of a block.
class LockCommand : public ChangeCommand<BlockLocks, std::vector<std::string>> {
  public:
    /// `after` holds the ids of all values that are locked afterwards.
    LockCommand(Document& document, const BlockPath& path, std::vector<std::string> after,
                const QString& label);

  private:
    void apply(const std::vector<std::string>& ids) override;
};

} // namespace patina
