// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/parameter_command.h"

#include "catalog/fills.h"

namespace patina {

namespace {

Values heldNow(const Document& document, const BlockPath& path, const Block& block) {
    Values values;
    for (const Parameter& parameter : block.parameters) {
        values.emplace(parameter.id, document.value(path, parameter));
    }
    return values;
}

/// The part of `values` that `after` changes.
Values before(const Values& values, const Values& after) {
    Values part;
    for (const auto& [id, value] : after) {
        part.emplace(id, values.at(id));
    }
    return part;
}

} // namespace

ParameterCommand::ParameterCommand(Document& document, const BlockPath& path, const Block& block,
                                   const Parameter& parameter, const Value& after)
    : ParameterCommand(document, path, parameter, heldNow(document, path, block),
                       afterEdit(block, heldNow(document, path, block), parameter, after)) {}

ParameterCommand::ParameterCommand(Document& document, const BlockPath& path,
                                   const Parameter& parameter, const Values& held,
                                   const Values& after)
    : ChangeCommand(document,
                    Document::tr("Change %1").arg(QString::fromStdString(parameter.label)),
                    ParameterTarget{path, parameter.id}, before(held, after), after) {}

void ParameterCommand::apply(const Values& values) {
    for (const auto& [id, value] : values) {
        storeValue(state(), target().path, id, value);
    }
    if (target().path.side != Side::A) {
        showSidesOn(target().path.index);
    }
    for (const auto& [id, value] : values) {
        document().announce({DocumentChange::Value, target().path, id});
    }
}

} // namespace patina
