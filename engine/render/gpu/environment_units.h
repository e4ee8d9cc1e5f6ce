// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/program.h"

namespace patina::environment {

/// Sets the texture units of the environment's samplers in a linked program (binding.h).
void assignUnits(const gl::Program& program);

} // namespace patina::environment
