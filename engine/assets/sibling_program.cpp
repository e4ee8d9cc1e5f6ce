// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/sibling_program.h"

#include <system_error>

namespace patina {

std::filesystem::path siblingProgram(const std::string& name) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path here = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    const fs::path beside = here / name;
    const fs::path installed = here.parent_path() / "libexec" / "patina" / name;
    return !fs::exists(beside, ignored) && fs::exists(installed, ignored) ? installed : beside;
}

} // namespace patina
