// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/kind_checks.h"

#include <algorithm>

#include <fmt/format.h>

namespace patina {

namespace {

/// Returns an argument whose key is also the name by which `patina eval` calls a kind; null where
/// there is none.
const ArgumentField* takenKey(const BlockKind& kind) {
    for (const BlockFunction& function : kind.functions) {
        for (const ArgumentField& field : function.fields) {
            if (std::ranges::find(blockKinds(), field.key, &BlockKind::singular) !=
                blockKinds().end()) {
                return &field;
            }
        }
    }
    return nullptr;
}

} // namespace

std::string kindMistake(const BlockKind& kind) {
    if (const ArgumentField* field = takenKey(kind)) {
        return fmt::format("the kind \"{}\" calls an argument \"{}\", as a kind is called",
                           kind.folder, field->key);
    }
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
