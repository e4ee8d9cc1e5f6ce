// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/error.h"
#include "shading/glsl/shader_source.h"

namespace patina {

/// Returns the errors of a driver's log at the files and lines of `source`. It reads the forms of
/// Mesa ("1:12(5): error: ..."), NVIDIA ("1(12) : error C0000: ...") and AMD and Apple ("ERROR:
/// 1:12: ..."). Warnings are left out. A log without any known form is one error, with the whole
/// log as its text.
Errors compileErrors(std::string_view log, const ShaderSource& source);

} // namespace patina
