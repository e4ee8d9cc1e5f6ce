// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/part_command.h"

namespace patina {

namespace {

Material swapped(const Document& document, const MaterialTarget& target, BlockPath::Part part,
                 const Block* block) {
    const Material* material = materialAt(document.state(), target.object, target.side);
    return withPart(*material, partKind(part),
                    document.block({part, target.object, target.side}), block);
}

QString labelOf(BlockPath::Part part, const Block* block) {
    const bool isFresnel = part == BlockPath::Part::Fresnel;
    if (!block) {
        return isFresnel ? Document::tr("Fresnel off") : Document::tr("Highlight off");
    }
    const QString name = QString::fromStdString(block->label);
    return (isFresnel ? Document::tr("Fresnel %1") : Document::tr("Highlight %1")).arg(name);
}

} // namespace

PartCommand::PartCommand(Document& document, const MaterialTarget& target, BlockPath::Part part,
                         const Block* block)
    : MaterialCommand(document, target, swapped(document, target, part, block),
                      labelOf(part, block)) {}

} // namespace patina
