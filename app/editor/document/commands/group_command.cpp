// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/group_command.h"

#include <algorithm>
#include <utility>

namespace patina {

GroupCommand::GroupCommand(Document& document, const QString& label, Edits edits)
    : DocumentCommand(document, label), edits_(std::move(edits)) {}

void GroupCommand::redo() {
    for (const auto& edit : edits_) {
        edit->redo();
    }
}

void GroupCommand::undo() {
    for (auto edit = edits_.rbegin(); edit != edits_.rend(); ++edit) {
        (*edit)->undo();
    }
}

const Material* GroupCommand::origin(MaterialPlace& place) const {
    for (auto edit = edits_.rbegin(); edit != edits_.rend(); ++edit) {
        if (const Material* material = (*edit)->origin(place)) {
            return material;
        }
    }
    return nullptr;
}

bool GroupCommand::mergeWith(const QUndoCommand* next) {
    const auto* other = dynamic_cast<const GroupCommand*>(next);
    const auto isSame = [](const auto& a, const auto& b) { return a->isOfSameTarget(*b); };
    if (!other || !std::ranges::equal(edits_, other->edits_, isSame)) {
        return false;
    }
    for (std::size_t i = 0; i < edits_.size(); ++i) {
        edits_[i]->mergeWith(other->edits_[i].get());
    }
    setObsolete(std::ranges::all_of(edits_, [](const auto& edit) { return edit->isObsolete(); }));
    return true;
}

void pushAsOne(Document& document, const QString& label, GroupCommand::Edits edits) {
    if (edits.size() == 1) {
        document.undoStack().push(edits.front().release());
    } else if (!edits.empty()) {
        document.undoStack().push(new GroupCommand(document, label, std::move(edits)));
    }
}

} // namespace patina
