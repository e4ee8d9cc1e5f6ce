// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/environment_command.h"

namespace patina {

EnvironmentCommand::EnvironmentCommand(Document& document, std::optional<BlockValues> after,
                                       const QString& label)
    : ChangeCommand(document, Kind::Environment, label, {}, document.scene().environment,
                    std::move(after)) {}

void EnvironmentCommand::apply(const std::optional<BlockValues>& environment) {
    state().scene.environment = environment;
    Q_EMIT document().environmentReplaced();
}

} // namespace patina
