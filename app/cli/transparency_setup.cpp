// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/transparency_setup.h"

#include <fmt/format.h>

#include "cli/scene_block.h"
#include "material/block_values.h"

namespace patina {
namespace {

constexpr std::string_view transparencyKind = kinds::transparency;

std::string knownIds(const Catalog& catalog) {
    std::string known = "sorted";
    for (const Block* block : catalog.ofKind(transparencyKind)) {
        known += ", " + block->id;
    }
    return known;
}

Result<void> choose(Scene& scene, const std::string& choice, const Catalog& catalog) {
    if (choice == "sorted") {
        scene.setPart(kinds::transparency, std::nullopt);
        return {};
    }
    const Block* block = catalog.find(transparencyKind, choice);
    if (block == nullptr) {
        return failure(fmt::format("--transparency {}: no such kind of it", choice),
                       knownIds(catalog));
    }
    if (!scene.part(kinds::transparency) || scene.part(kinds::transparency)->id != choice) {
        scene.setPart(kinds::transparency, defaultBlockValues(*block));
    }
    return {};
}

} // namespace

Result<void> chooseTransparency(Scene& scene, const PictureOptions& options,
                                const Catalog& catalog) {
    if (!options.transparency.empty()) {
        if (auto chosen = choose(scene, options.transparency, catalog); !chosen) {
            return chosen;
        }
    }
    return assignAll({std::string(transparencyKind), scene.parts}, options.sets, catalog);
}

} // namespace patina
