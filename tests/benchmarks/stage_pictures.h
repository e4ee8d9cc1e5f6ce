// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "gl/texture.h"
#include "gl/texture_array.h"
#include "render/lights/shadow_view.h"
#include "scene/scene.h"

namespace patina::benchmarks {

/// What programs on the stage read beside numbers, on the texture units that the engine has for it:
/// an image (binding::firstTexture) and the map of the first light (binding::shadowMaps), in which
/// a board stands before half of the ball.
class StagePictures {
  public:
    StagePictures();

    void bind() const;

    /// How the map looks at a ball of radius 1.
    ShadowView shadowView(const Catalog& catalog, const Light& light,
                          const glm::dmat4& cameraToWorld) const;

  private:
    gl::Texture image_;
    gl::TextureArray depths_;
};

} // namespace patina::benchmarks
