// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "gl/texture.h"
#include "gl/texture_array.h"
#include "render/lights/shadow_view.h"
#include "scene/scene.h"

namespace patina::benchmarks {

/// Holds the images that programs on the stage read, on the texture units that the engine uses for
/// them: an image (binding::firstTexture) and the shadow map of the first light
/// (binding::shadowMaps), in which a board hides half of the ball.
class StagePictures {
  public:
    StagePictures();

    void bind() const;

    /// Returns the projection of the shadow map for a ball of radius 1.
    ShadowView shadowView(const Catalog& catalog, const Light& light,
                          const glm::dmat4& cameraToWorld) const;

  private:
    gl::Texture image_;
    gl::TextureArray depths_;
};

} // namespace patina::benchmarks
