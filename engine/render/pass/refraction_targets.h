// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "catalog/catalog.h"
#include "gl/framebuffer.h"
#include "gl/target_texture.h"
#include "render/gpu/hdr_target.h"
#include "render/lights/light_lists.h"
#include "shading/program/program_cache.h"

namespace patina {

/// Makes what objects that refract light need before they are drawn: the farthest surface of each,
/// and the picture and the depths of what was drawn before. Its memory (at most 24 bytes for each
/// pixel) is there only while it is in use.
class RefractionTargets {
  public:
    /// Holds what a frame's objects look at.
    struct Needs {
        bool back = false;   ///< the surface through which light leaves them
        bool behind = false; ///< the scene
    };

    /// Begins for pictures of `size` pixels, as HdrTarget::averagedSize().
    Result<void> begin(glm::ivec2 size, Needs needs, const Catalog& catalog, ProgramCache& cache);

    /// Draws go to the farthest surface of a body within the ball, whose picture is cleared first
    /// where `isNew`.
    void beginBack(const Ball& ball, bool isNew) const;

    /// Takes what is in the target now for what is behind the next objects.
    void takeBehind(const HdrTarget& target) const;
    bool needsSceneColor() const { return built_.behind; }

    /// Binds all this for a program that draws a body within the ball and is in use.
    void bind(const gl::Program& program, const Ball& ball, const HdrTarget& target) const;

    /// Tells a program that has been linked where it finds all this (binding.h).
    static void assignUnits(const gl::Program& program);

    /// The shader files may have changed.
    void forget() { backProgram_.reset(); }

  private:
    Result<void> buildBack();
    Result<void> buildBehind();
    Result<void> makeProgram(const Catalog& catalog, ProgramCache& cache);

    glm::ivec2 size_{0};
    Needs built_;
    gl::TargetTexture back_;
    gl::TargetTexture backDepth_;
    gl::Framebuffer backTarget_;
    gl::TargetTexture behindDepth_;
    gl::Framebuffer behindTarget_;
    std::shared_ptr<const gl::Program> backProgram_;
};

} // namespace patina
