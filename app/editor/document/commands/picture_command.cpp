// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/picture_command.h"

namespace patina {

PictureCommand::PictureCommand(Document& document, std::optional<ComparedPicture> after)
    : ChangeCommand(document, Document::tr("Compare"), document.selection().object(),
                    document.state().picture, std::move(after)) {}

void PictureCommand::apply(const std::optional<ComparedPicture>& picture) {
    state().picture = picture;
    document().announce({DocumentChange::Material});
}

} // namespace patina
