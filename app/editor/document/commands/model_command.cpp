// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/model_command.h"

#include "catalog/fills.h"
#include "catalog/value_json.h"
#include "material/model_swap.h"

namespace patina {

namespace {

/// Tells whether a value carries over from the former model, or was parked when this model was last
/// in use.
bool isCarriedOver(const Parameter& parameter, const Material& material, const Block* before) {
    const Parameter* former = before ? before->parameter(parameter.id) : nullptr;
    return (former && former->type == parameter.type) || material.parked.contains(parameter.id);
}

/// Sets the parameters to which nothing carries over to the user's start values.
void begin(Values& values, const nlohmann::json& start, const Material& material,
           const Block* before, const Block& model) {
    for (const auto& [id, json] : start.items()) {
        const Parameter* parameter = model.parameter(id);
        const bool isFree = parameter && !isCarriedOver(*parameter, material, before);
        const ValueReading value =
            isFree ? valueFromJson(*parameter, json) : ValueReading(Value(0.0));
        if (isFree && value) {
            values.insert_or_assign(id, roundedToFloat(conformed(*parameter, *value)));
        }
    }
    settleShorthands(model, values);
}

Material swapped(const Document& document, const MaterialPlace& target, const Block& model) {
    const Material* material = materialAt(document.state(), target.object, target.side);
    Material next = swappedModel(*material, model, document.catalog());
    const auto start = document.startValues().find(model.id);
    if (start != document.startValues().end() && start->second.is_object()) {
        const Block* before = document.catalog().find(kinds::models, material->model.id);
        begin(next.model.parameters, start->second, *material, before, model);
    }
    return next;
}

} // namespace

ModelCommand::ModelCommand(Document& document, const MaterialPlace& target, const Block& model)
    : MaterialCommand(document, target, swapped(document, target, model),
                      Document::tr("Model %1").arg(QString::fromStdString(model.label))) {}

} // namespace patina
