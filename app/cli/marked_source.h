// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "shading/effects/effect_set.h"
#include "shading/glsl/shader_source.h"

namespace patina {

/// Returns the text of a shader stage for reading: a comment before each file's part names the file
/// and, where it belongs to an effect, the effect and why it is in. Lines of the text, by their
/// 1-based numbers, have a margin before them where there is any.
std::string markedSource(std::string_view title, const ShaderSource& source,
                         const std::vector<EffectLine>& effects,
                         const std::map<int, std::string>& margins = {});

} // namespace patina
