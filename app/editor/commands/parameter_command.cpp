// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/parameter_command.h"

namespace patina {

ParameterCommand::ParameterCommand(Document& document, const BlockPath& path,
                                   const Parameter& parameter, const Value& after)
    : ChangeCommand(document, Kind::Parameter,
                    Document::tr("Change %1").arg(QString::fromStdString(parameter.label)),
                    ParameterTarget{path, parameter.id}, document.value(path, parameter), after) {}

void ParameterCommand::apply(const Value& value) {
    storeValue(state(), target().path, target().parameterId, value);
    Q_EMIT document().valueChanged(target().path, QString::fromStdString(target().parameterId));
}

} // namespace patina
