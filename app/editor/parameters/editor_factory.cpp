// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/editor_factory.h"

#include <array>

namespace patina {

ParameterEditor* makeEditor(const Parameter& parameter, QWidget* parent) {
#define PATINA_EDITOR_MAKER(name) &make##name##Editor,
    static constexpr std::array makers{PATINA_PARAMETER_TYPES(PATINA_EDITOR_MAKER)};
#undef PATINA_EDITOR_MAKER
    return makers[static_cast<std::size_t>(parameter.type)](parameter, parent);
}

} // namespace patina
