// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shading/glsl/shader_source.h"

namespace patina {

/// Returns the source without the functions, structs, constants and macros that main() does not
/// reach, so that a library file adds only what is called. Lines keep their numbers through
/// `#line`. A text without a main(), or whose braces do not match, stays as it is.
ShaderSource withoutUnused(ShaderSource source);

} // namespace patina
