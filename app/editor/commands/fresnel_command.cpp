// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/fresnel_command.h"

namespace patina {

namespace {

Material swapped(const Document& document, const MaterialTarget& target, const Block* block) {
    const BlockPath path{BlockPath::Part::Fresnel, target.object, target.side};
    const Material* material = materialAt(document.state(), target.object, target.side);
    return withFresnel(*material, document.block(path), block);
}

QString labelOf(const Block* block) {
    return block ? Document::tr("Fresnel %1").arg(QString::fromStdString(block->label))
                 : Document::tr("Fresnel off");
}

} // namespace

FresnelCommand::FresnelCommand(Document& document, const MaterialTarget& target, const Block* block)
    : MaterialCommand(document, target, swapped(document, target, block), labelOf(block)) {}

} // namespace patina
