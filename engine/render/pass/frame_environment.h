// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/lights/environment_light.h"
#include "render/pass/accumulation.h"
#include "render/pass/data_packer.h"
#include "render/view.h"

namespace patina {

/// Holds the part that an environment has in frames: its light's data, what is seen behind the
/// objects, and the mean of the frames of one picture. Nothing of it exists without an environment.
class FrameEnvironment {
  public:
    /// Holds what views share of it.
    struct Shared {
        ProgramCache& cache;
        EnvironmentPictures& pictures;
    };

    /// Prepares a frame of the scene, up to and with the first thing that takes long: true as long
    /// as there may be more, and the next call goes on.
    Result<bool> begin(const SceneToPack& scene, const View& view, const Catalog& catalog,
                       const Shared& shared);

    /// Tells whether the frame that was prepared looks at an environment.
    bool isIn() const { return light_.isIn(); }

    /// Tells whether its picture is a mean of frames, because some material's light is sampled.
    bool isSampled() const { return isIn() && count_ > 0; }

    /// As begin() for a frame that is not to be seen: what the mean holds stays.
    void prewarm(const SceneToPack& scene, const View& view, const Catalog& catalog,
                 const Shared& shared);

    /// Returns what a level white surface that faces up reflects of it, seen from anywhere.
    glm::dvec3 upward() const { return isIn() ? light_.upward() : glm::dvec3(0.0); }

    /// See EnvironmentLight::radiance().
    EnvironmentRadiance radiance() const { return light_.radiance(); }

    /// Draws into the target that is bound, whose viewport is all of it.
    void drawBackground(const Camera& camera, const glm::dmat4& cameraToWorld, double aspect) const;

    /// Binds it for the objects that are drawn next.
    void bind() const;

    /// Call it when all of the frame is in this picture: its samples join the mean.
    void add(const gl::Texture& frame);

    /// Uses the program that add() does on a mean of its own, behind prewarm(): drivers compile
    /// when something is drawn.
    void addUnseen(const gl::Texture& frame, const Catalog& catalog, ProgramCache& cache) const;

    /// Samples per pixel that are in the mean; 0 until the first frame of a picture is done.
    int samples() const;

    /// Rounds of samples of the frame that was prepared; 0 without an environment.
    int rounds() const;

    /// Tells whether what was drawn last is in the mean.
    bool hasPicture() const { return done_ > 0; }

    const gl::Texture& picture() const { return accumulation_.mean(); }
    unsigned framebuffer() const { return accumulation_.framebuffer(); }

    /// Tells whether the mean is a picture of this size.
    bool holds(glm::ivec2 size) const;

    void forget();

  private:
    EnvironmentLight light_;
    Accumulation accumulation_;
    gl::VertexArray noVertices_ = gl::VertexArray::create();
    int done_ = 0;  ///< samples in the mean
    int count_ = 1; ///< of the frame that is being drawn
};

} // namespace patina
