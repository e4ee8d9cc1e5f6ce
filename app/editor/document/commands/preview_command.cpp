// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/preview_command.h"

namespace patina {

PreviewCommand::PreviewCommand(Document& document, std::optional<MaterialPreview> after)
    : ChangeCommand(document, Document::tr("Compare"), document.selection().object(),
                    document.state().preview, std::move(after)) {}

void PreviewCommand::apply(const std::optional<MaterialPreview>& preview) {
    state().preview = preview;
    document().announce({DocumentChange::Material});
}

} // namespace patina
