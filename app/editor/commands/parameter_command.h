// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/change_command.h"

namespace patina {

/// Which value a parameter edit changes.
struct ParameterTarget {
    BlockPath path;
    std::string parameterId;

    friend bool operator==(const ParameterTarget&, const ParameterTarget&) = default;
};

/// Changes one value of a model, Fresnel block, light, fog, object or of the scene.
class ParameterCommand : public ChangeCommand<ParameterTarget, Value> {
  public:
    ParameterCommand(Document& document, const BlockPath& path, const Parameter& parameter,
                     const Value& after);

  private:
    void apply(const Value& value) override;
};

} // namespace patina
