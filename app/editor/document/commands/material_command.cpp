// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/material_command.h"

namespace patina {

MaterialCommand::MaterialCommand(Document& document, const MaterialPlace& target,
                                 const Material& after, const QString& label, MaterialEdit edit)
    : ChangeCommand(document, label, target,
                    *materialAt(document.state(), target.object, target.side), after),
      edit_(edit) {}

const Material* MaterialCommand::origin(MaterialPlace& place) const {
    return edit_ == MaterialEdit::Applied && place == target() ? &after() : nullptr;
}

void MaterialCommand::apply(const Material& material) {
    if (Material* held = materialAt(state(), target().object, target().side)) {
        *held = material;
        if (target().side != Side::A) {
            showSidesOn(target().object);
        }
        document().announce({DocumentChange::Material});
    }
}

} // namespace patina
