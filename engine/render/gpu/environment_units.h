// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/program.h"

namespace patina::environment {

/// Tells a program that has been linked where it finds the environment (binding.h).
void assignUnits(const gl::Program& program);

} // namespace patina::environment
