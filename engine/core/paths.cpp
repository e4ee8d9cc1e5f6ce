// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paths.h"

#include <algorithm>

namespace patina {

namespace fs = std::filesystem;

bool isWithin(const fs::path& path, const fs::path& folder) {
    return !folder.empty() &&
           std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
               folder.end();
}

bool leadsWithin(const fs::path& path, const fs::path& folder) {
    std::error_code noFolder;
    std::error_code circle;
    const fs::path to = fs::weakly_canonical(path, circle);
    const fs::path from = fs::weakly_canonical(folder, noFolder);
    return !circle && !noFolder && isWithin(to, from);
}

} // namespace patina
