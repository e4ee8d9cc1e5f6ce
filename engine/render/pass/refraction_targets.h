// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "catalog/catalog.h"
#include "core/convex_facets.h"
#include "gl/framebuffer.h"
#include "gl/target_texture.h"
#include "gl/vertex_array.h"
#include "render/gpu/hdr_target.h"
#include "render/lights/placement.h"
#include "shading/program/program_cache.h"

namespace patina {

/// Draws what refracting objects read: the farthest surface of each, and the picture and the depths
/// of what was drawn before. Its memory (at most 26 bytes for each pixel) exists only while it is
/// in use.
class RefractionTargets {
  public:
    /// Says which images a frame's objects read.
    struct Needs {
        bool back = false;   ///< is the surface through which light leaves an object
        bool behind = false; ///< is the scene behind an object
    };

    /// Makes the images and programs that are needed for pictures of `size` pixels, which is
    /// HdrTarget::averagedSize(). After an error of the images nothing is allocated.
    Result<void> begin(glm::ivec2 size, Needs needs, const Catalog& catalog, ProgramCache& cache);

    /// Directs drawing to the image of the farthest surface of a body within the ball; clears the
    /// image first if `isNew`.
    void beginBack(const Ball& ball, bool isNew) const;

    /// Copies the target's colour and depth as what is behind the next objects, with the depths
    /// that its tiles reach. Neither the target nor a program that was in use is so any more.
    void takeBehind(const HdrTarget& target) const;
    bool needsSceneColor() const { return built_.behind; }

    /// Binds the images for a program that is in use and draws a body within the ball.
    void bind(const gl::Program& program, const Ball& ball, const HdrTarget& target) const;

    /// Sets the facets of a body for a program that is in use and follows rays among them; one that
    /// has none in the world, as it is flattened, counts as a body without.
    static void setFacets(const gl::Program& program, const Placement& placement,
                          const ConvexFacets& facets);

    /// Sets the texture units of the images in a linked program (binding.h).
    static void assignUnits(const gl::Program& program);

    /// Drops the programs, because the shader files may have changed.
    void forget() {
        backProgram_.reset();
        reachProgram_.reset();
    }

  private:
    Result<void> buildBack();
    Result<void> buildBehind();
    Result<void> makePrograms(const Catalog& catalog, ProgramCache& cache);
    void drawReach() const;

    glm::ivec2 size_{0};
    Needs built_;
    gl::TargetTexture back_;
    gl::TargetTexture backDepth_;
    gl::Framebuffer backTarget_;
    gl::TargetTexture behindDepth_;
    gl::Framebuffer behindTarget_;
    int reachLevel_ = 0; ///< is the level of the depths that holds those of tiles
    gl::Framebuffer reachTarget_;
    gl::VertexArray noVertices_ = gl::VertexArray::create();
    std::shared_ptr<const gl::Program> backProgram_;
    std::shared_ptr<const gl::Program> reachProgram_;
};

} // namespace patina
