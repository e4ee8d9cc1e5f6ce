// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "measure/lobe/lobe_lines.h"

namespace patina {

/// Returns the line of LobePlot::Float16: how far a material's model is from double precision in
/// the plane of incidence, in units in the last place of a float of 16 bits, where every operation
/// of the model and of what it calls is rounded to such floats. What is no longer finite has no
/// digit left and counts as 2048. It is an error where the text cannot be evaluated.
Result<LobeLines> halfLines(const Catalog& catalog, const Material& material,
                            const LobeRequest& request, const std::filesystem::path& shaders);

} // namespace patina
