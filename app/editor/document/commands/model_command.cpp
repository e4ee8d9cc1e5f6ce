// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/model_command.h"

#include "material/model_swap.h"

namespace patina {

namespace {

Material swapped(const Document& document, const MaterialPlace& target, const Block& model) {
    const Material* material = materialAt(document.state(), target.object, target.side);
    return swappedModel(*material, model, document.catalog());
}

} // namespace

ModelCommand::ModelCommand(Document& document, const MaterialPlace& target, const Block& model)
    : MaterialCommand(document, target, swapped(document, target, model),
                      Document::tr("Model %1").arg(QString::fromStdString(model.label))) {}

} // namespace patina
