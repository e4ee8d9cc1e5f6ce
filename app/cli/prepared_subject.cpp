// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/prepared_subject.h"

#include "cli/environment_setup.h"
#include "cli/scene_setup.h"

namespace patina {

Checked<Prepared> prepared(const std::string& preset, const PictureOptions& options,
                           const Catalog& catalog, AssetClient& files) {
    auto setup = sceneFor(preset, options, catalog);
    if (!setup) {
        return tl::unexpected(setup.error());
    }
    report(setup->notes);
    files.setRights(setup->rights);
    auto loaded = SceneMeshes::load(setup->scene, catalog, files);
    if (!loaded) {
        return tl::unexpected(loaded.error());
    }
    report(loaded->remarks());
    const auto environment = environmentPicture(setup->scene, options, catalog, files);
    if (!environment) {
        return tl::unexpected(oneError(environment.error()));
    }
    return Prepared{preset, std::move(setup->scene), std::move(*loaded), *environment};
}

} // namespace patina
