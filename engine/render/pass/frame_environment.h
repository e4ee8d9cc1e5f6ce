// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/lights/environment_light.h"
#include "render/pass/accumulation.h"
#include "render/pass/data_packer.h"
#include "render/view.h"

namespace patina {

/// Holds what frames need of an environment: the data of its light, the picture behind the objects,
/// and the mean of the frames of one picture. Without an environment it takes no memory.
class FrameEnvironment {
  public:
    /// Names what views share of their environments.
    struct Shared {
        ProgramCache& cache;
        EnvironmentPictures& pictures;
    };

    /// Prepares a frame in steps, each up to the first long step of work. Returns true while there
    /// may be more to do; then it must be called again.
    Result<bool> begin(const SceneToPack& scene, const View& view, const Catalog& catalog,
                       const Shared& shared);

    /// Returns true when the frame that was prepared has an environment.
    bool isIn() const { return light_.isIn(); }

    /// Returns true when the picture is a mean of frames, because the environment's light is
    /// sampled.
    bool isSampled() const { return isIn() && count_ > 0; }

    /// Does the same as begin() for a frame that nobody sees, at once and without changing the
    /// mean.
    void prewarm(const SceneToPack& scene, const View& view, const Catalog& catalog,
                 const Shared& shared);

    /// Returns the linear radiance that a white matte surface facing up reflects; 0 without an
    /// environment.
    glm::dvec3 upward() const { return isIn() ? light_.upward() : glm::dvec3(0.0); }

    /// Returns EnvironmentLight::radiance().
    EnvironmentRadiance radiance() const { return light_.radiance(); }

    /// Draws the environment into the bound target, where its depth is that of nothing; does
    /// nothing where it is hidden. `aspect` is width over height.
    void drawBackground(const Camera& camera, const glm::dmat4& cameraToWorld, double aspect) const;

    /// Binds the environment's data for the objects that are drawn next.
    void bind() const;

    /// Adds a finished frame to the mean, weighted by its number of samples.
    void add(const gl::Texture& frame);

    /// Draws with the program of add() into an image of its own, after prewarm(), because drivers
    /// compile when something is drawn.
    void addUnseen(const gl::Texture& frame, const Catalog& catalog, ProgramCache& cache) const;

    /// Returns the samples per pixel in the mean; 0 until the first frame of a picture is done.
    int samples() const;

    /// Returns the rounds of samples in the frame that was prepared; 0 when none are taken.
    int rounds() const;

    /// Returns true when the mean has at least one frame of the current picture.
    bool hasPicture() const { return done_ > 0; }

    const gl::Texture& picture() const { return accumulation_.mean(); }
    unsigned framebuffer() const { return accumulation_.framebuffer(); }

    /// Returns true when the mean has a frame and this size, in pixels.
    bool holds(glm::ivec2 size) const;

    void forget();

  private:
    EnvironmentLight light_;
    Accumulation accumulation_;
    gl::VertexArray noVertices_ = gl::VertexArray::create();
    int done_ = 0;  ///< is the number of samples in the mean
    int count_ = 1; ///< is the number of samples of the frame that is being drawn
};

} // namespace patina
