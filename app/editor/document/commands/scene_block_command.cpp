// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/scene_block_command.h"

namespace patina {
namespace {

std::optional<BlockValues> heldAt(const Document& document, const BlockPath& path) {
    const BlockValues* held = blockValuesAt(document.state(), path);
    return held ? std::optional(*held) : std::nullopt;
}

} // namespace

SceneBlockCommand::SceneBlockCommand(Document& document, const BlockPath& path,
                                     std::optional<BlockValues> after, const QString& label)
    : ChangeCommand(document, label, path, heldAt(document, path), std::move(after)) {}

void SceneBlockCommand::apply(const std::optional<BlockValues>& values) {
    setPart(*scenePartsAt(state(), target()), target().kind, values);
    document().announce({DocumentChange::Block, target()});
}

} // namespace patina
