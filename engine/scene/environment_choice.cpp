// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/environment_choice.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "material/block_values.h"
#include "scene/environment.h"

namespace patina {
namespace {

constexpr std::string_view environmentKind = kinds::environment;

std::string knownEnvironments(const Catalog& catalog) {
    std::string known;
    for (const Block* block : catalog.ofKind(environmentKind)) {
        known += block->id + ", ";
    }
    return known + "none, or an .hdr or .exr file";
}

const Block* blockWithPicture(const Catalog& catalog) {
    const std::vector<const Block*> blocks = catalog.ofKind(environmentKind);
    const auto found = std::find_if(blocks.begin(), blocks.end(), [](const Block* block) {
        return pictureParameter(*block) != nullptr;
    });
    return found == blocks.end() ? nullptr : *found;
}

} // namespace

Result<void> chooseEnvironment(Scene& scene, const std::string& choice, const Catalog& catalog) {
    if (choice == findKind(environmentKind)->noneWord) {
        scene.setPart(environmentKind, std::nullopt);
        return {};
    }
    if (const Block* block = catalog.find(environmentKind, choice)) {
        scene.setPart(environmentKind, defaultBlockValues(*block));
        return {};
    }
    const Block* block = blockWithPicture(catalog);
    std::error_code ignored; // a file that cannot be asked about is none
    if (block == nullptr || !std::filesystem::is_regular_file(choice, ignored)) {
        return failure(
            fmt::format("--environment {}: no such environment and no such file", choice),
            knownEnvironments(catalog));
    }
    BlockValues values = defaultBlockValues(*block);
    values.parameters[pictureParameter(*block)->id] =
        std::filesystem::absolute(choice).generic_string();
    scene.setPart(environmentKind, std::move(values));
    return {};
}

} // namespace patina
