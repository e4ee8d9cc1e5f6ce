// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/change_command.h"

namespace patina {

/// Changes one value of a model, Fresnel block, light, fog, object or of the scene, and those that
/// it decides with it.
class ParameterCommand : public ChangeCommand<ParameterTarget, Values> {
  public:
    ParameterCommand(Document& document, const BlockPath& path, const Block& block,
                     const Parameter& parameter, const Value& after);

  private:
    ParameterCommand(Document& document, const BlockPath& path, const Parameter& parameter,
                     const Values& held, const Values& after);
    void apply(const Values& values) override;
};

} // namespace patina
