// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shading/program/program_source.h"

namespace patina {

/// Returns the program that draws the farthest surface of a body, for a target of 32-bit floats:
/// with the uniform `refractionBody`, the middle and the radius of a ball around the body.
Checked<ProgramSource> bodyBackProgram(const Catalog& catalog);

/// Returns the program that fills a level of depths with those that tiles of the picture reach.
Checked<ProgramSource> tileReachProgram(const Catalog& catalog);

} // namespace patina
