// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/parameter_editor.h"

namespace patina {

/// Makes the editor for a parameter's type; `parent` owns it.
ParameterEditor* makeEditor(const Parameter& parameter, QWidget* parent);

/// Declares a function for each type that makes its editor; it is defined beside the editor.
#define PATINA_EDITOR_MAKER(name)                                                                  \
    ParameterEditor* make##name##Editor(const Parameter& parameter, QWidget* parent);
PATINA_PARAMETER_TYPES(PATINA_EDITOR_MAKER)
#undef PATINA_EDITOR_MAKER

} // namespace patina
