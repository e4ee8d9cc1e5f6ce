// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/light_command.h"

namespace patina {

LightCommand::LightCommand(Document& document, int index, std::optional<Light> before,
                           std::optional<Light> after, const QString& label)
    : ListCommand(document, label, index, std::move(before), std::move(after),
                  document.selection().light()) {}

std::vector<Light>& LightCommand::list() const {
    return state().scene.lights;
}

void LightCommand::announce() const {
    document().announce({DocumentChange::Lights});
}

void LightCommand::setCurrent(int index) const {
    document().selection().setLight(index);
}

} // namespace patina
