// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/commands/change_command.h"

namespace patina {

/// Replaces a whole material (a preset dropped on it, its name or tags changed).
class MaterialCommand : public ChangeCommand<MaterialPlace, Material> {
  public:
    /// The material at the target must exist.
    MaterialCommand(Document& document, const MaterialPlace& target, const Material& after,
                    const QString& label, MaterialEdit edit = MaterialEdit::Changed);

    const Material* origin(MaterialPlace& place) const override;

  private:
    void apply(const Material& material) override;

    MaterialEdit edit_;
};

} // namespace patina
