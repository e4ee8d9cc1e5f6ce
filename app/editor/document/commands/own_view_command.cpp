// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/own_view_command.h"

namespace patina {

OwnViewCommand::OwnViewCommand(Document& document, Side side, OwnView after, const QString& label)
    : ChangeCommand(document, label, side, document.state().ownViews[indexOf(side)],
                    std::move(after)) {}

void OwnViewCommand::apply(const OwnView& own) {
    state().ownViews[indexOf(target())] = own;
    BlockPath path = pathOf(settings::scene, 0, target());
    path.isOfView = true;
    document().announce({DocumentChange::OwnView, path});
}

} // namespace patina
