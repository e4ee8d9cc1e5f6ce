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

Checked<std::vector<Prepared>> allPrepared(const std::vector<std::string>& presets,
                                           const CostRequest& options, const Catalog& catalog,
                                           AssetClient& files) {
    std::vector<Prepared> all;
    for (const std::string& preset : presets) {
        auto subject = prepared(preset, options.picture, catalog, files);
        if (!subject) {
            return tl::unexpected(subject.error());
        }
        all.push_back(std::move(*subject));
    }
    return all;
}

std::string nameOf(const Prepared& subject, const CostRequest& options) {
    if (!subject.preset.empty()) {
        return subject.preset;
    }
    return options.picture.model.empty() ? options.picture.scene : options.picture.model;
}

} // namespace patina
