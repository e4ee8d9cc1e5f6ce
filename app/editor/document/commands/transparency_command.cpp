// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/transparency_command.h"

namespace patina {

TransparencyCommand::TransparencyCommand(Document& document, std::optional<BlockValues> after,
                                       const QString& label)
    : ChangeCommand(document, Kind::Transparency, label, {}, document.scene().transparency,
                    std::move(after)) {}

void TransparencyCommand::apply(const std::optional<BlockValues>& transparency) {
    state().scene.transparency = transparency;
    Q_EMIT document().transparencyReplaced();
}

} // namespace patina
