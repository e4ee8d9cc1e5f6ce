// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/snapshots_command.h"

namespace patina {

SnapshotsCommand::SnapshotsCommand(Document& document, const QString& label,
                                   std::vector<Snapshot> after)
    : ChangeCommand(document, label, AllSnapshots(), document.state().snapshots, std::move(after)) {
}

void SnapshotsCommand::apply(const std::vector<Snapshot>& snapshots) {
    state().snapshots = snapshots;
    document().announce({DocumentChange::Snapshots});
}

} // namespace patina
