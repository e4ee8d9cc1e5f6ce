// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/compare_command.h"

namespace patina {

CompareCommand::CompareCommand(Document& document, std::optional<Material> after)
    : ChangeCommand(document, after ? Document::tr("Compare") : Document::tr("Stop comparing"),
                    document.selection().object(), document.state().second, std::move(after)) {}

const Material* CompareCommand::origin(MaterialPlace& place) const {
    return place.side == Side::B && after() ? &*after() : nullptr;
}

void CompareCommand::apply(const std::optional<Material>& second) {
    const bool isSame = state().second.has_value() == second.has_value();
    state().second = second;
    showSidesOn(target());
    DocumentChange change{DocumentChange::Material};
    change.aspects.setFlag(DocumentChange::Comparing, !isSame);
    document().announce(change);
}

} // namespace patina
