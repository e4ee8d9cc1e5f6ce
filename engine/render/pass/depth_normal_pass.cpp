// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/depth_normal_pass.h"

#include <array>

#include <epoxy/gl.h>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>

#include "render/gpu/binding.h"
#include "render/pass/frame_gpu.h"
#include "render/plan/prepared_frame.h"
#include "shading/effects/display_set.h"

namespace patina {
namespace {

constexpr unsigned normalUnit = 2;
constexpr unsigned depthUnit = 3;

} // namespace

Result<bool> DepthNormalPass::prepare(PreparedFrame& frame, FrameGpu& gpu) {
    isDone_ = !displaySet(*frame.plan.effects, *gpu.shared.catalog).readSurfaces();
    if (isDone_) {
        if (!frame.plan.isUnseen) {
            images_.reset();
        }
        return false;
    }
    if (auto made = makeProgram(gpu); !made) {
        return tl::unexpected(made.error());
    }
    if (auto fitted = fit(frame.plan.view->size); !fitted) {
        return tl::unexpected(fitted.error());
    }
    return false;
}

Result<void> DepthNormalPass::makeProgram(FrameGpu& gpu) {
    if (program_) {
        return {};
    }
    const auto source = pictureSurfacesProgram(*gpu.shared.catalog);
    if (!source) {
        return tl::unexpected(source.error().front());
    }
    const ProgramCache::Found found = gpu.shared.programs().get(*source);
    if (!found.program) {
        return tl::unexpected(found.errors.front());
    }
    program_ = found.program;
    program_->bindBlock("ViewBlock", binding::view);
    return {};
}

Result<void> DepthNormalPass::fit(glm::ivec2 size) {
    if (images_ && images_->size == size) {
        return {};
    }
    images_ = std::make_unique<Images>();
    images_->size = size;
    images_->normals = gl::TargetTexture::create(size, GL_RGBA16F, 1);
    images_->depths = gl::TargetTexture::create(size, GL_RG32F, 1);
    images_->nearest = gl::Renderbuffer::create(size, GL_DEPTH_COMPONENT32F, 1);
    images_->framebuffer = gl::Framebuffer::create();
    images_->framebuffer.attachColor(images_->normals, 0);
    images_->framebuffer.attachColor(images_->depths, 1);
    images_->framebuffer.attachDepth(images_->nearest);
    return images_->framebuffer.check();
}

/// Draws each object alone, since it has a number of its own. What is drawn where nobody sees it
/// leaves the images as they are, by its empty scissor rectangle.
bool DepthNormalPass::draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget&) {
    if (isDone_) {
        return true;
    }
    isDone_ = true;
    glBindFramebuffer(GL_FRAMEBUFFER, images_->framebuffer.name());
    glViewport(0, 0, images_->size.x, images_->size.y);
    setBlendState(BlendState::Opaque);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDisable(GL_CULL_FACE);
    static constexpr std::array<float, 4> none{};
    static constexpr std::array<float, 4> farAway{1e30f};
    glClearBufferfv(GL_COLOR, 0, none.data());
    glClearBufferfv(GL_COLOR, 1, farAway.data());
    static constexpr float farthest = 1.0f;
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    gpu.data.bind();
    program_->use();
    const glm::mat3 turn(frame.plan.worldToCamera);
    glUniformMatrix3fv(program_->uniform("worldToCamera"), 1, GL_FALSE, glm::value_ptr(turn));
    const int number = program_->uniform("objectNumber");
    for (const DrawBatch& batch : frame.list.batches()) {
        for (std::size_t i = batch.first; i < batch.first + batch.count; ++i) {
            const PlannedItem& item = frame.plan.items[frame.list.items()[i]];
            glUniform1f(number, static_cast<float>(item.index + 1));
            batch.mesh->draw(gpu.data.instances(), {0, batch.mesh->triangles(), i, 1});
        }
    }
    gpu.data.forgetProgram();
    glDisable(GL_DEPTH_TEST);
    return true;
}

void DepthNormalPass::bind() const {
    if (images_) {
        images_->normals.bind(normalUnit);
        images_->depths.bind(depthUnit);
        glActiveTexture(GL_TEXTURE0);
    }
}

void DepthNormalPass::nameUnits(const gl::Program& program) {
    program.bindSampler("normalImage", normalUnit);
    program.bindSampler("depthImage", depthUnit);
}

} // namespace patina
