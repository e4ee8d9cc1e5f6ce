// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/parameter_editor.h"

namespace patina {

/// Returns the editor of a parameter's type.
ParameterEditor* makeEditor(const Parameter& parameter, QWidget* parent);

/// Declares what makes the editors of each type; each stands beside its editor.
#define PATINA_EDITOR_MAKER(name)                                                                  \
    ParameterEditor* make##name##Editor(const Parameter& parameter, QWidget* parent);
PATINA_PARAMETER_TYPES(PATINA_EDITOR_MAKER)
#undef PATINA_EDITOR_MAKER

} // namespace patina
