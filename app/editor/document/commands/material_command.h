// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/change_command.h"

namespace patina {

/// Says which material of a document is meant.
struct MaterialPlace {
    int object = 0;
    Side side = Side::A;

    friend bool operator==(const MaterialPlace&, const MaterialPlace&) = default;
};

/// Replaces a whole material (a preset dropped on it, its name or tags changed).
class MaterialCommand : public ChangeCommand<MaterialPlace, Material> {
  public:
    /// The material at the target must exist.
    MaterialCommand(Document& document, const MaterialPlace& target, const Material& after,
                    const QString& label);

  private:
    void apply(const Material& material) override;
};

} // namespace patina
