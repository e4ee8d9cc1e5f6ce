// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "document/commands/change_command.h"

namespace patina {

/// Names all snapshots of a document, as the target of an edit.
struct AllSnapshots {
    friend bool operator==(const AllSnapshots&, const AllSnapshots&) = default;
};

/// Takes, renames or removes snapshots.
class SnapshotsCommand : public ChangeCommand<AllSnapshots, std::vector<Snapshot>> {
  public:
    SnapshotsCommand(Document& document, const QString& label, std::vector<Snapshot> after);

  private:
    void apply(const std::vector<Snapshot>& snapshots) override;
};

} // namespace patina
