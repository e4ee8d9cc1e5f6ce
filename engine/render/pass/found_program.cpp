// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/found_program.h"

namespace patina {

Result<std::shared_ptr<const gl::Program>> foundProgram(const Checked<ProgramSource>& source,
                                                        ProgramCache& cache) {
    if (!source) {
        return tl::unexpected(source.error().front());
    }
    const ProgramCache::Found made = cache.get(*source);
    if (!made.program) {
        return tl::unexpected(made.errors.front());
    }
    return made.program;
}

} // namespace patina
