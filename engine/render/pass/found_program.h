// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/error.h"
#include "shading/program/program_cache.h"

namespace patina {

/// Returns the program of a source that may have failed, compiled or from the cache; fails with the
/// first mistake of either.
Result<std::shared_ptr<const gl::Program>> foundProgram(const Checked<ProgramSource>& source,
                                                        ProgramCache& cache);

} // namespace patina
