// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/compare_command.h"

namespace patina {

CompareCommand::CompareCommand(Document& document, std::optional<Material> after)
    : ChangeCommand(document, Kind::Compare,
                    after ? Document::tr("Compare") : Document::tr("Stop comparing"),
                    document.currentObject(), document.state().second, std::move(after)) {}

void CompareCommand::apply(const std::optional<Material>& second) {
    const bool was = state().second.has_value();
    state().second = second;
    showSecondOn(target());
    if (was != second.has_value()) {
        Q_EMIT document().comparingChanged(second.has_value());
    }
    Q_EMIT document().materialChanged(document().currentObject(), Side::B);
}

} // namespace patina
