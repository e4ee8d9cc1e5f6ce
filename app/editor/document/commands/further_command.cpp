// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/further_command.h"

namespace patina {

FurtherCommand::FurtherCommand(Document& document, std::vector<Material> after)
    : ChangeCommand(document, Document::tr("Compare"), FurtherSides{document.selection().object()},
                    document.state().further, std::move(after)) {}

const Material* FurtherCommand::origin(MaterialPlace& place) const {
    const std::size_t index = indexOf(place.side) - indexOf(Side::C);
    const bool isFurther = place.side == Side::C || place.side == Side::D;
    const bool isNew = isFurther && index < after().size() &&
                       (index >= before().size() || !(before()[index] == after()[index]));
    return isNew ? &after()[index] : nullptr;
}

void FurtherCommand::apply(const std::vector<Material>& further) {
    state().further = further;
    showSidesOn(target().object);
    document().announce({DocumentChange::Material | DocumentChange::Comparing});
}

} // namespace patina
