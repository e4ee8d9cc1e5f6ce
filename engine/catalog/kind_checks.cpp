// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/kind_checks.h"

#include <algorithm>

#include <fmt/format.h>

namespace patina {

std::string kindMistake(const BlockKind& kind) {
    const auto found = std::ranges::find_if(kind.functions, [](const BlockFunction& function) {
        return function.argument == "Directions" && !function.suffix.empty();
    });
    return found == kind.functions.end()
               ? std::string()
               : fmt::format("the kind \"{}\" has a function \"{}\" of Directions, and only the "
                             "one that is named as its block may be one",
                             kind.folder, found->suffix);
}

} // namespace patina
