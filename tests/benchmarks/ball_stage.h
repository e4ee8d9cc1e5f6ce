// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <glm/mat4x4.hpp>

#include "core/image.h"
#include "gl/framebuffer.h"
#include "gl/headless_context.h"
#include "render/gpu/gpu_mesh.h"
#include "render/lights/frustum.h"
#include "scene/scene.h"
#include "stage_pictures.h"

namespace patina::benchmarks {

/// Draws a ball that fills most of a square target, with one sample per pixel. The caller provides
/// the program.
class BallStage {
  public:
    static constexpr int usualSize = 512;

    /// `size` is the target's width in pixels.
    explicit BallStage(int size = usualSize);

    /// Makes a program and what it reads current.
    using Use = std::function<void()>;

    double secondsPerFrame(const Use& use);
    Image picture(const Use& use);

    const Camera& camera() const { return camera_; }
    glm::dmat4 worldToClip() const;
    static constexpr glm::dmat4 objectToWorld{1.0};
    const StagePictures& pictures() const { return *pictures_; }

  private:
    void draw(const Use& use);

    static constexpr int framesAtOnce = 4;

    int size_;
    std::unique_ptr<gl::HeadlessContext> context_;
    Camera camera_;
    DepthRange depths_;
    gl::Renderbuffer color_;
    gl::Renderbuffer depth_;
    gl::Framebuffer target_;
    std::optional<GpuMesh> mesh_;
    std::optional<SingleInstance> place_;
    std::optional<StagePictures> pictures_;
};

} // namespace patina::benchmarks
