// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/object_command.h"

namespace patina {

ObjectCommand::ObjectCommand(Document& document, int index, std::optional<Object> before,
                             std::optional<Object> after, const QString& label)
    : ListCommand(document, label, index, std::move(before), std::move(after),
                  document.selection().object()) {}

const Material* ObjectCommand::origin(MaterialPlace& place) const {
    if (place.side != Side::A || isReplacement()) {
        return nullptr;
    }
    if (isAddition() && place.object == target()) {
        return &after()->material;
    }
    if (place.object >= target()) { // those behind it moved up or down
        place.object += isAddition() ? -1 : 1;
    }
    return nullptr;
}

std::vector<Object>& ObjectCommand::list() const {
    return state().scene.objects;
}

void ObjectCommand::announce() const {
    document().announce({DocumentChange::Objects});
}

void ObjectCommand::setCurrent(int index) const {
    document().selection().setObject(index);
    document().selection().setObjects({}); // the others' places in the list may have changed
}

} // namespace patina
