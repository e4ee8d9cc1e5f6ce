// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/program_in_path.h"

#include <cstdlib>
#include <sstream>
#include <system_error>

namespace patina {

std::filesystem::path programInPath(const std::string& name) {
    const char* const paths = std::getenv("PATH");
    std::istringstream folders(paths == nullptr ? "" : paths);
    std::string folder;
    while (std::getline(folders, folder, ':')) {
        std::error_code missing;
        std::filesystem::path program = std::filesystem::path(folder) / name;
        if (!folder.empty() && std::filesystem::is_regular_file(program, missing)) {
            return program;
        }
    }
    return {};
}

} // namespace patina
