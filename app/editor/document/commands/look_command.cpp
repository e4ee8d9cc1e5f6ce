// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/look_command.h"

namespace patina {

LookCommand::LookCommand(Document& document, std::optional<LookedAt> after)
    : ChangeCommand(document, Document::tr("Compare"), document.currentObject(),
                    document.state().lookedAt, std::move(after)) {}

void LookCommand::apply(const std::optional<LookedAt>& lookedAt) {
    state().lookedAt = lookedAt;
    document().announce({DocumentChange::Material});
}

} // namespace patina
