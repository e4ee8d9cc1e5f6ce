// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "document/commands/document_command.h"

namespace patina {

/// Does several edits as one step: the same edit of every selected object. Within one interaction
/// two groups merge where each edit of the one is of the same target as that of the other.
class GroupCommand : public DocumentCommand {
  public:
    using Edits = std::vector<std::unique_ptr<DocumentCommand>>;

    GroupCommand(Document& document, const QString& label, Edits edits);

    void redo() override;
    void undo() override;
    bool mergeWith(const QUndoCommand* next) override;
    const Material* origin(MaterialPlace& place) const override;

  private:
    Edits edits_;
};

/// Pushes edits as one step: a single one as it is, and nothing where there are none.
void pushAsOne(Document& document, const QString& label, GroupCommand::Edits edits);

} // namespace patina
