// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/passes_command.h"

namespace patina {

PassesCommand::PassesCommand(Document& document, std::vector<BlockValues> after,
                             const QString& label)
    : ChangeCommand(document, label, AllPasses(), document.scene().passes, std::move(after)) {}

void PassesCommand::apply(const std::vector<BlockValues>& passes) {
    state().scene.passes = passes;
    document().announce({DocumentChange::Block, pathOf(kinds::pass)});
}

} // namespace patina
