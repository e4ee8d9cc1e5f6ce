// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "measure/interpreter/shader_syntax.h"
#include "shading/glsl/shader_source.h"

namespace patina {

/// Parses the function `root` of a shader and all that it calls. It is an error, at its file, line
/// and column, where one of these uses what the evaluator does not know: images,
/// unsigned numbers, operators on bits. `source` must outlive the result.
Result<ShaderSyntax> parsedShader(const ShaderSource& source, std::string_view root);

} // namespace patina
