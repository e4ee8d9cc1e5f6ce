// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/lock_command.h"

#include "document/value_locks.h"

namespace patina {

LockCommand::LockCommand(Document& document, const BlockPath& path, std::vector<std::string> after,
                         const QString& label)
    : ChangeCommand(document, label, BlockLocks{path}, lockedValues(document.state(), path),
                    std::move(after)) {}

void LockCommand::apply(const std::vector<std::string>& ids) {
    storeLockedValues(state(), target().path, ids);
    document().announce({DocumentChange::Locks, target().path});
}

} // namespace patina
