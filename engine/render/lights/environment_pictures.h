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
    /// Takes in some megabytes more of the whole picture; false where there was nothing left of it.
    bool fillSome();

    std::shared_ptr<const EnvironmentImage> image; ///< null: black, in place of what is on its way
    EnvironmentTexture whole;
    EnvironmentTexture small;
};

/// The pictures of environments that are in the GPU's memory, each once however many views show it.
class EnvironmentPictures {
  public:
    /// Returns the picture of an image, or the black one, and whether room was made for it now. It
    /// stays for as long as somebody holds it.
    std::pair<std::shared_ptr<EnvironmentPicture>, bool>
    of(const std::shared_ptr<const EnvironmentImage>& image);

  private:
    std::vector<std::weak_ptr<EnvironmentPicture>> pictures_;
};

} // namespace patina
