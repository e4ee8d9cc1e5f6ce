// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "shading/effects/effect_set.h"
#include "shading/glsl/shader_source.h"

namespace patina {

/// A stage's text for people: where a file's part begins a comment names the file and, where it is
/// that of an effect, the effect and why it is in.
std::string markedSource(std::string_view title, const ShaderSource& source,
                         const std::vector<EffectLine>& effects);

} // namespace patina
