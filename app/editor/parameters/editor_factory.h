// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/parameter_editor.h"

namespace patina {

/// The editor of a parameter's type.
ParameterEditor* makeEditor(const Parameter& parameter, QWidget* parent);

} // namespace patina
