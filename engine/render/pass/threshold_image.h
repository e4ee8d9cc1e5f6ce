// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "core/texture_picture.h"
#include "gl/texture.h"
#include "render/gpu/gpu_texture_store.h"
#include "render/gpu/texture_source.h"

namespace patina {

/// Returns the brightness of an image as thresholds from 0 to 1, each as frequent as any other, so
/// that the share of the image below a threshold is that threshold: equal ones are told apart at
/// random. Rows go up; the size is that of the largest level that is at most 512 texels wide and
/// high.
struct Thresholds {
    glm::ivec2 size{0};
    std::vector<float> values;
};
Thresholds thresholdsOf(const TexturePicture& picture);

/// Holds the image whose thresholds a picture pass reads. It repeats; without a file, or until that
/// is there, everything is 1/2.
class ThresholdImage {
  public:
    /// Takes the image of this file, which may be empty. Returns false while it is being loaded.
    bool take(const std::string& file, const GpuTextureStore& images);

    /// Binds it to a texture unit, which it leaves active; does nothing before take().
    void bind(unsigned unit) const;

  private:
    void show(const Thresholds& thresholds);

    std::shared_ptr<const TexturePicture> shown_; ///< is null while there is none
    gl::Texture texture_;
};

} // namespace patina
