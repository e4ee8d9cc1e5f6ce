// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball_stage.h"

#include <epoxy/gl.h>

#include "cpu_clock.h"
#include "render/gpu/capture_image.h"
#include "scene/primitives.h"

namespace patina::benchmarks {

BallStage::BallStage(int size)
    : size_(size), context_(gl::HeadlessContext::create().value()) {
    camera_.yaw = 15.0;
    camera_.pitch = 15.0;
    camera_.distance = 3.6;
    const Mesh ball = primitive("sphere").value();
    depths_.add(ball.bounds, viewMatrix(camera_));
    color_ = gl::Renderbuffer::create({size, size}, GL_RGBA16F);
    depth_ = gl::Renderbuffer::create({size, size}, GL_DEPTH_COMPONENT24);
    target_ = gl::Framebuffer::create();
    target_.attachColor(color_);
    target_.attachDepth(depth_);
    mesh_.emplace(ball.view());
    while (!mesh_->isComplete()) {
        mesh_->upload(ball.view(), std::size_t(1) << 30);
    }
    place_.emplace().place(objectToWorld);
    pictures_.emplace().bind();
    glViewport(0, 0, size, size);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_DITHER);
}

glm::dmat4 BallStage::worldToClip() const {
    return projection(camera_, 1.0, depths_) * viewMatrix(camera_);
}

void BallStage::draw(const Use& use) {
    glBindFramebuffer(GL_FRAMEBUFFER, target_.name());
    use();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    mesh_->draw(*place_);
}

double BallStage::secondsPerFrame(const Use& use) {
    glFinish();
    const double began = workSeconds();
    for (int i = 0; i < framesAtOnce; ++i) {
        draw(use);
    }
    glFinish();
    return (workSeconds() - began) / framesAtOnce;
}

Image BallStage::picture(const Use& use) {
    draw(use);
    return readLinear(target_.name(), {size_, size_}, 0.0);
}

} // namespace patina::benchmarks
