// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/environment_setup.h"

#include "cli/command.h"
#include "scene/environment.h"

namespace patina {
namespace {

constexpr std::string_view environmentKind = kinds::environment;

} // namespace

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
    return options.samples > 0 ? options.samples : unaskedDirections(scene, catalog);
}

} // namespace patina
