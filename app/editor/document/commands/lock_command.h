// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "document/commands/change_command.h"

namespace patina {

/// The locks of a block's values.
struct BlockLocks {
    BlockPath path;

    friend bool operator==(const BlockLocks&, const BlockLocks&) = default;
};

/// Locks values of a block, or frees them.
class LockCommand : public ChangeCommand<BlockLocks, std::vector<std::string>> {
  public:
    /// `after`: the ids of all that are locked then.
    LockCommand(Document& document, const BlockPath& path, std::vector<std::string> after,
                const QString& label);

  private:
    void apply(const std::vector<std::string>& ids) override;
};

} // namespace patina
