// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shading/effects/opacity_part.h"
#include "shading/program/program_source.h"

namespace patina {

/// Returns the program that finds the depths of the next layer of a surface: with the sampler
/// `nearerLayer`, and `samplerName(0)` for the opacity's image where there is one.
Checked<ProgramSource> peelProgram(const OpacityPart& part, const Catalog& catalog,
                                   bool isMultisampled);

/// Returns the program that puts a sum of layers over what is behind them: with the sampler
/// `layerSum`, and `layerShare` where they are not in order.
Checked<ProgramSource> layerComposition(const Catalog& catalog, bool isPeeled, bool isMultisampled);

} // namespace patina
