// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <glm/mat4x4.hpp>

#include "core/image.h"
#include "gl/framebuffer.h"
#include "gl/headless_context.h"
#include "render/frustum.h"
#include "render/gpu_mesh.h"
#include "scene/scene.h"

namespace patina::benchmarks {

/// A ball that fills most of a target with one sample per pixel. What draws it says how.
class BallStage {
  public:
    BallStage();

    /// Makes a program and what it reads the current ones.
    using Use = std::function<void()>;

    double secondsPerFrame(const Use& use);
    Image picture(const Use& use);

    const Camera& camera() const { return camera_; }
    glm::dmat4 worldToClip() const;

  private:
    void draw(const Use& use);

    static constexpr int size = 512;
    static constexpr int framesAtOnce = 4;

    std::unique_ptr<gl::HeadlessContext> context_;
    Camera camera_;
    DepthRange depths_;
    gl::Renderbuffer color_;
    gl::Renderbuffer depth_;
    gl::Framebuffer target_;
    std::optional<GpuMesh> mesh_;
    std::optional<SingleInstance> place_;
};

} // namespace patina::benchmarks
