// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/fog_command.h"

namespace patina {

FogCommand::FogCommand(Document& document, std::optional<BlockValues> after, const QString& label)
    : ChangeCommand(document, Kind::Fog, label, {}, document.scene().fog, std::move(after)) {}

void FogCommand::apply(const std::optional<BlockValues>& fog) {
    state().scene.fog = fog;
    Q_EMIT document().fogReplaced();
}

} // namespace patina
