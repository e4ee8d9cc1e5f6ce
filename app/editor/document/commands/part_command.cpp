// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/part_command.h"

namespace patina {

namespace {

Material swapped(const Document& document, const MaterialPlace& target, BlockPath::Part part,
                 const Block* block) {
    const Material* material = materialAt(document.state(), target.object, target.side);
    return withPart(*material, partKind(part),
                    document.block({part, target.object, target.side}), block);
}

QString labelOff(BlockPath::Part part) {
    switch (part) {
    case BlockPath::Part::Fresnel:
        return Document::tr("Fresnel off");
    case BlockPath::Part::Refraction:
        return Document::tr("Refraction off");
    case BlockPath::Part::Outline:
        return Document::tr("Outline off");
    default:
        return Document::tr("Highlight off");
    }
}

QString labelOf(BlockPath::Part part, const Block* block) {
    if (!block) {
        return labelOff(part);
    }
    const QString name = QString::fromStdString(block->label);
    switch (part) {
    case BlockPath::Part::Fresnel:
        return Document::tr("Fresnel %1").arg(name);
    case BlockPath::Part::Refraction:
        return Document::tr("Refraction %1").arg(name);
    case BlockPath::Part::Outline:
        return Document::tr("Outline %1").arg(name);
    default:
        return Document::tr("Highlight %1").arg(name);
    }
}

} // namespace

PartCommand::PartCommand(Document& document, const MaterialPlace& target, BlockPath::Part part,
                         const Block* block)
    : MaterialCommand(document, target, swapped(document, target, part, block),
                      labelOf(part, block)) {}

} // namespace patina
