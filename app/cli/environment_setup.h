// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "assets/asset_client.h"
#include "catalog/catalog.h"
#include "cli/picture_options.h"
#include "render/lights/environment_image.h"
#include "scene/scene.h"

namespace patina {

/// The picture that the scene's environment is made of; null where it needs none. One that cannot
/// be read is an error where the options name it; where a scene does, a warning on standard error,
/// and a placeholder takes its place.
Result<std::shared_ptr<const EnvironmentImage>> environmentPicture(const Scene& scene,
                                                                   const PictureOptions& options,
                                                                   const Catalog& catalog,
                                                                   AssetClient& client);

/// Returns how many directions per pixel the environment's light is summed from: `--samples`, else
/// what the scene says, but no more than 256. Any number without an environment.
int directionsFor(const Scene& scene, const PictureOptions& options, const Catalog& catalog);

} // namespace patina
