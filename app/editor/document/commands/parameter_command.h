// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "document/commands/change_command.h"

namespace patina {

/// Names values of one block that change together.
struct ValuesTarget {
    BlockPath path;
    std::vector<std::string> ids;

    friend bool operator==(const ValuesTarget&, const ValuesTarget&) = default;
};

/// Changes values of a model, Fresnel block, light, fog, object or of the scene, and those that
/// depend on them.
class ParameterCommand : public ChangeCommand<ValuesTarget, Values> {
  public:
    ParameterCommand(Document& document, const BlockPath& path, const Block& block,
                     const Parameter& parameter, const Value& after);

    /// Changes several values of the block at once; those that depend on them follow.
    ParameterCommand(Document& document, const BlockPath& path, const Block& block,
                     const Values& given, const QString& label);

  private:
    ParameterCommand(Document& document, const BlockPath& path, const QString& label,
                     const Values& held, const Values& after);
    void apply(const Values& values) override;
};

} // namespace patina
