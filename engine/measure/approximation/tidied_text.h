// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "shading/glsl/shader_source.h"

namespace patina {

/// Returns a source in which some of its functions, by name, are as an author writes them: without
/// factors of 1 and summands of 0, operations between numbers, branches that are never taken,
/// statements without effect or behind a return, variables that nothing reads, and parentheses that
/// change nothing. What the functions give stays. A text that does not parse stays as it is.
ShaderSource tidiedSource(ShaderSource source, std::string_view root,
                          const std::set<std::string>& functions);

} // namespace patina
