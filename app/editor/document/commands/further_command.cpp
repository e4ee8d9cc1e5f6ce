// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/further_command.h"

namespace patina {

FurtherCommand::FurtherCommand(Document& document, std::vector<Material> after)
    : ChangeCommand(document, Document::tr("Compare"), FurtherSides{document.currentObject()},
                    document.state().further, std::move(after)) {}

void FurtherCommand::apply(const std::vector<Material>& further) {
    state().further = further;
    showSidesOn(target().object);
    document().announce({DocumentChange::Material | DocumentChange::Comparing});
}

} // namespace patina
