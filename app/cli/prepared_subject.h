// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "assets/asset_client.h"
#include "cli/command.h"
#include "cli/cost_request.h"
#include "cli/long_work.h"
#include "cli/scene_meshes.h"
#include "render/gpu/texture_loader.h"
#include "render/lights/environment_image.h"
#include "scene/scene.h"

namespace patina {

/// Holds what is read of a preset before anything is measured.
struct Prepared {
    std::string preset;
    Scene scene;
    SceneMeshes meshes;
    std::shared_ptr<const EnvironmentImage> environment;
};

/// Reads the scene that is measured, with a preset on its first object unless that is empty; notes
/// are reported.
Checked<Prepared> prepared(const std::string& preset, const PictureOptions& options,
                           const Catalog& catalog, AssetClient& files);

/// Reads every preset before the first is measured, so that a mistake in the last one costs no
/// measurement.
Checked<std::vector<Prepared>> allPrepared(const std::vector<std::string>& presets,
                                           const CostRequest& options, const Catalog& catalog,
                                           AssetClient& files);

/// Returns the name of what was prepared: its preset, or else the model or the scene.
std::string nameOf(const Prepared& subject, const CostRequest& options);

/// Holds what all measurements use.
struct Tools {
    std::shared_ptr<const Catalog> catalog;
    AssetClient& files;
    LongWork& work;
};

/// Calls `measure` with what was prepared, and reports images that could not be read.
template <class Measure>
auto withSubject(const Prepared& subject, const CostRequest& options, const Tools& tools,
                 const Measure& measure) {
    TextureLoader textures(tools.files);
    auto measured =
        measure({subject.scene, 0, subject.scene.camera,
                 [&subject](const Object& object) { return subject.meshes.view(object); },
                 tools.catalog, textures.source(), subject.environment},
                options, tools.work);
    report(textures.takeProblems());
    return measured;
}

} // namespace patina
