// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/accuracy_text.h"

#include <fmt/format.h>

#include "material/blocks_in_use.h"

namespace patina {
namespace {

/// Returns the block's choice that a name means, with a prefix or without; null where it means
/// none.
const AccuracyChoice* choiceNamed(const Block& block, const std::string& name) {
    for (const std::string& before : {std::string("accuracy"), block.kind}) {
        if (name.starts_with(before + '.')) {
            if (const auto* choice = block.accuracyChoice(name.substr(before.size() + 1))) {
                return choice;
            }
        }
    }
    return block.accuracyChoice(name);
}

} // namespace

bool hasChosenLevels(std::string_view kind) {
    const BlockKind* known = findKind(kind);
    return known != nullptr && known->owner == BlockOwner::Material;
}

const AccuracyChoice* accuracyChoiceIn(const Material& material, const std::string& name,
                                       const Catalog& catalog) {
    for (const Block* block : blocksInUse(material, catalog)) {
        if (const AccuracyChoice* choice = choiceNamed(*block, name)) {
            return choice;
        }
    }
    return nullptr;
}

Result<bool> setLevel(Material& material, const std::string& name, const std::string& level,
                      const Catalog& catalog) {
    const AccuracyChoice* choice = accuracyChoiceIn(material, name, catalog);
    if (choice == nullptr) {
        return false;
    }
    std::string known;
    for (const EnumValue& value : choice->values) {
        if (value.id == level) {
            material.accuracy[choice->id] = level;
            return true;
        }
        known += (known.empty() ? "one of " : ", ") + value.id;
    }
    return failure(fmt::format("{}: \"{}\" is not a level of it", name, level), known);
}

} // namespace patina
