// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/environment_setup.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "cli/command.h"
#include "material/block_values.h"
#include "scene/environment.h"

namespace patina {
namespace {

constexpr std::string_view environmentKind = kinds::environment;

/// Directions that a scene gets without being asked for: more of them take long.
constexpr int maxUnasked = 256;

std::string knownIds(const Catalog& catalog) {
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
            knownIds(catalog));
    }
    BlockValues values = defaultBlockValues(*block);
    values.parameters[pictureParameter(*block)->id] =
        std::filesystem::absolute(choice).generic_string();
    scene.setPart(environmentKind, std::move(values));
    return {};
}

Result<std::shared_ptr<const EnvironmentImage>> environmentPicture(const Scene& scene,
                                                                   const PictureOptions& options,
                                                                   const Catalog& catalog,
                                                                   AssetClient& client) {
    const Block* block = blockOf(scene.parts, kinds::environment, catalog);
    const std::string_view file = block == nullptr
                                      ? std::string_view()
                                      : pictureFile(*scene.part(kinds::environment), *block);
    if (file.empty()) {
        return nullptr;
    }
    const Result<Image> panorama = client.loadImage(std::filesystem::path(file));
    if (!panorama && options.part(environmentKind).empty()) {
        report(Errors{panorama.error()});
        return EnvironmentImage::missing();
    }
    return panorama.map(EnvironmentImage::from);
}

int directionsFor(const Scene& scene, const PictureOptions& options, const Catalog& catalog) {
    if (options.samples > 0) {
        return options.samples;
    }
    const Block* block = blockOf(scene.parts, kinds::environment, catalog);
    return block == nullptr
               ? maxUnasked
               : std::min(directionsOf(*scene.part(kinds::environment), *block), maxUnasked);
}

} // namespace patina
