// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "render/lights/environment_image.h"
#include "render/lights/environment_texture.h"

namespace patina {

/// Holds an environment's picture in the GPU's memory.
struct EnvironmentPicture {
    /// Uploads some megabytes more of the whole picture; returns false when nothing was left.
    bool fillSome();

    std::shared_ptr<const EnvironmentImage> image; ///< is null for the black picture that is used
                                                   ///< while the real one is missing
    EnvironmentTexture whole;
    EnvironmentTexture small;
};

/// Knows the environments' pictures in the GPU's memory, so that views share one picture.
class EnvironmentPictures {
  public:
    /// Returns the picture of an image (the black one for null), and whether it was allocated by
    /// this call. The picture lives as long as somebody holds it.
    std::pair<std::shared_ptr<EnvironmentPicture>, bool>
    of(const std::shared_ptr<const EnvironmentImage>& image);

  private:
    std::vector<std::weak_ptr<EnvironmentPicture>> pictures_;
};

} // namespace patina
