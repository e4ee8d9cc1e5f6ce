// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "assets/asset_client.h"
#include "catalog/catalog.h"
#include "cli/picture_options.h"
#include "render/lights/environment_image.h"
#include "scene/scene.h"

namespace patina {

/// Returns the picture of the scene's environment; null where it needs none. A picture that cannot
/// be read is an error where the options name it; where the scene does, it is a warning on standard
/// error, and a placeholder is returned.
Result<std::shared_ptr<const EnvironmentImage>> environmentPicture(const Scene& scene,
                                                                   const PictureOptions& options,
                                                                   const Catalog& catalog,
                                                                   AssetClient& client);

/// Returns how many directions per pixel the environment's light is summed from: `--samples`, else
/// what the scene says, but no more than 256. Without an environment the number has no effect.
int directionsFor(const Scene& scene, const PictureOptions& options, const Catalog& catalog);

} // namespace patina
