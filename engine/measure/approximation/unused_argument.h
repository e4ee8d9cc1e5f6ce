// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "measure/approximation/shader_edit.h"

namespace patina {

/// Returns the edits that take an argument that is never read out of one of these functions and of
/// its calls, in the order of the text; none where there is no such argument, or where another
/// function calls it too.
std::vector<ShaderEdit> withoutUnusedArgument(const ShaderSyntax& syntax,
                                              const std::set<std::string>& functions);

} // namespace patina
