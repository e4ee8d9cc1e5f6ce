// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/part_command.h"

#include "document/block_label.h"

namespace patina {

namespace {

Material withBlock(const Document& document, const BlockPath& path, const Block* block) {
    const Material* material = materialAt(document.state(), path.index, path.side);
    return withPart(*material, path.kind, document.block(path), block);
}

} // namespace

PartCommand::PartCommand(Document& document, const BlockPath& path, const Block* block)
    : MaterialCommand(document, {path.index, path.side}, withBlock(document, path, block),
                      blockLabel(path.kind, block)) {}

} // namespace patina
