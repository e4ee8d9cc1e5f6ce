// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/layer_composer.h"

#include <algorithm>
#include <utility>

#include <epoxy/gl.h>

#include "render/gpu/binding.h"
#include "render/gpu/slow_allocation.h"
#include "render/pass/found_program.h"
#include "shading/effects/layer_source.h"
#include "shading/effects/texture_writer.h"

namespace patina {
namespace {

int samplesOf(const HdrTarget& target) {
    GLint samples = 0;
    target.bind();
    glGetIntegerv(GL_SAMPLES, &samples);
    return std::max(samples, 1);
}

void clearColor(int location, const std::array<float, 4>& value) {
    glClearBufferfv(GL_COLOR, location, value.data());
}

void maskColors(GLboolean written) {
    glColorMask(written, written, written, written);
}

} // namespace

Result<bool> LayerComposer::begin(const HdrTarget& target, int layers, const Catalog& catalog,
                                  ProgramCache& cache) {
    const Shape wanted{target.drawnSize(), samplesOf(target), layers > 0};
    if (!(wanted == shape_)) {
        leaveOut();
        shape_ = wanted;
    }
    while (!isBuilt_) {
        if (auto built = buildNext(); !built) {
            leaveOut();
            return tl::unexpected(built.error());
        }
        if (isSlowToAllocate(shape_.size)) {
            return true;
        }
    }
    if (!composition_) {
        return makeComposition(catalog, cache).map([] { return true; });
    }
    layers_ = layers;
    progress_ = Progress();
    isIn_ = true;
    return false;
}

void LayerComposer::leaveOut() {
    if (isIn_ || shape_.samples > 0) {
        isIn_ = false;
        shape_ = Shape();
        sum_ = gl::TargetTexture();
        share_ = gl::TargetTexture();
        mixed_ = gl::Framebuffer();
        sides_ = {};
        isBuilt_ = false;
        forget();
    }
}

void LayerComposer::forget() {
    composition_.reset();
    depthPrograms_.clear();
}

/// Makes the next image; the last call also sets isBuilt_.
Result<void> LayerComposer::buildNext() {
    if (sum_.name() == 0) {
        sum_ = gl::TargetTexture::create(shape_.size, GL_RGBA32F, shape_.samples);
        return {};
    }
    if (shape_.isPeeled) {
        const bool isFirst = sides_[0].framebuffer.name() == 0;
        isBuilt_ = !isFirst;
        return buildSide(sides_[isFirst ? 0 : 1]);
    }
    share_ = gl::TargetTexture::create(shape_.size, GL_R32F, shape_.samples);
    mixed_ = gl::Framebuffer::create();
    mixed_.attachColor(sum_, 0);
    mixed_.attachColor(share_, 1);
    isBuilt_ = true;
    return mixed_.check();
}

Result<void> LayerComposer::buildSide(Side& side) {
    side.depths = gl::TargetTexture::create(shape_.size, GL_DEPTH_COMPONENT32F, shape_.samples);
    side.framebuffer = gl::Framebuffer::create();
    side.framebuffer.attachColor(sum_, 0);
    side.framebuffer.attachDepth(side.depths);
    side.isAnySeen = gl::SampleQuery::create();
    return side.framebuffer.check();
}

Result<void> LayerComposer::makeComposition(const Catalog& catalog, ProgramCache& cache) {
    auto made = foundProgram(layerComposition(catalog, shape_.isPeeled, isMultisampled()), cache);
    if (!made) {
        return tl::unexpected(made.error());
    }
    composition_ = std::move(*made);
    composition_->bindSampler("layerSum", binding::layerSum);
    composition_->bindSampler("layerShare", binding::layerShare);
    return {};
}

Result<void> LayerComposer::addPipeline(const std::shared_ptr<const Pipeline>& pipeline,
                                        ProgramCache& cache) {
    if (!shape_.isPeeled || depthPrograms_.contains(pipeline)) {
        return {};
    }
    const OpacityPart part = opacityPart(pipeline->effects, pipeline->object);
    auto made = foundProgram(peelProgram(part, *pipeline->catalog, isMultisampled()), cache);
    if (!made) {
        return tl::unexpected(made.error());
    }
    (*made)->bindBlock("ViewBlock", binding::view);
    (*made)->bindBlock("ObjectBlock", binding::object);
    (*made)->bindSampler("nearerLayer", binding::nearerLayer);
    if (part.hasImage()) {
        (*made)->bindSampler(samplerName(0).c_str(),
                             binding::firstTexture + static_cast<unsigned>(*part.image));
    }
    depthPrograms_.emplace(pipeline, std::move(*made));
    return {};
}

void LayerComposer::useDepths(const std::shared_ptr<const Pipeline>& pipeline) const {
    depthPrograms_.at(pipeline)->use();
}

bool LayerComposer::draw(const HdrTarget& target, const DrawObjects& drawObjects) {
    const bool isDone =
        shape_.isPeeled ? drawInOrder(target, drawObjects) : drawMixed(target, drawObjects);
    glDepthMask(GL_TRUE);
    if (isDone) {
        compose(target);
    }
    return isDone;
}

void LayerComposer::drawUnseen(const HdrTarget& target, const DrawObjects& drawObjects) {
    progress_.isUnseen = true;
    draw(target, drawObjects);
}

void LayerComposer::beginConditionOf(const Side& side) const {
    if (!progress_.isUnseen) {
        side.isAnySeen.beginCondition();
    }
}

void LayerComposer::endCondition() const {
    if (!progress_.isUnseen) {
        gl::SampleQuery::endCondition();
    }
}

/// Peels layers by depth (C. Everitt, Interactive order-independent transparency, 2001). Each layer
/// is blended under those before it, whose alpha is what they transmit. Once no sample has another
/// layer, the device skips all drawing.
bool LayerComposer::drawInOrder(const HdrTarget& target, const DrawObjects& drawObjects) {
    if (!std::exchange(progress_.isCleared, true)) {
        clearLayers();
    }
    for (; progress_.layer < layers_; ++progress_.layer) {
        if (!std::exchange(progress_.hasDepths, true) && !drawDepths(target, drawObjects)) {
            return false;
        }
        if (!drawLayer(drawObjects)) {
            return false;
        }
        progress_.hasDepths = false;
    }
    return true;
}

/// Clears the sum, and the side that is read for the first layer to a depth at the eye.
void LayerComposer::clearLayers() const {
    static constexpr float nearest = 0.0f;
    glBindFramebuffer(GL_FRAMEBUFFER, side(1).framebuffer.name());
    maskColors(GL_TRUE);
    glDepthMask(GL_TRUE);
    clearColor(0, {0.0f, 0.0f, 0.0f, 1.0f});
    glClearBufferfv(GL_DEPTH, 0, &nearest);
}

/// Draws the depths of the nearest surfaces that are behind the last layer and in front of solid
/// objects.
bool LayerComposer::drawDepths(const HdrTarget& target, const DrawObjects& drawObjects) const {
    const Side& at = side(progress_.layer);
    const Side& nearer = side(progress_.layer + 1);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, at.framebuffer.name());
    glDepthMask(GL_TRUE);
    glBlitFramebuffer(0, 0, shape_.size.x, shape_.size.y, 0, 0, shape_.size.x, shape_.size.y,
                      GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, at.framebuffer.name());
    if (progress_.layer > 0) {
        beginConditionOf(nearer);
    }
    maskColors(GL_FALSE);
    glDisable(GL_BLEND);
    glDepthFunc(GL_LESS);
    nearer.depths.bind(binding::nearerLayer);
    at.isAnySeen.begin();
    const bool goesOn = drawObjects(Stage::Depths);
    gl::SampleQuery::end();
    if (progress_.layer > 0) {
        endCondition();
    }
    return goesOn;
}

bool LayerComposer::drawLayer(const DrawObjects& drawObjects) const {
    const Side& at = side(progress_.layer);
    glBindFramebuffer(GL_FRAMEBUFFER, at.framebuffer.name());
    beginConditionOf(at);
    maskColors(GL_TRUE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_DST_ALPHA, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
    const bool isDone = drawObjects(Stage::Layers);
    endCondition();
    return isDone;
}

/// Sums weighted colours and multiplies what the surfaces transmit (McGuire and Bavoil 2013).
bool LayerComposer::drawMixed(const HdrTarget& target, const DrawObjects& drawObjects) {
    mixed_.attachDepth(target.depth()); // may differ from that of the last frame
    maskColors(GL_TRUE);
    if (!std::exchange(progress_.isCleared, true)) {
        clearColor(0, {0.0f, 0.0f, 0.0f, 0.0f});
        clearColor(1, {1.0f, 1.0f, 1.0f, 1.0f});
    }
    glEnable(GL_BLEND);
    glBlendFunci(0, GL_ONE, GL_ONE);
    glBlendFunci(1, GL_ZERO, GL_ONE_MINUS_SRC_COLOR);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_FALSE);
    return drawObjects(Stage::Layers);
}

void LayerComposer::compose(const HdrTarget& target) const {
    target.bind();
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_SRC_ALPHA, GL_ZERO, GL_ONE);
    sum_.bind(binding::layerSum);
    if (!shape_.isPeeled) {
        share_.bind(binding::layerShare);
    }
    composition_->use();
    noVertices_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glActiveTexture(GL_TEXTURE0);
}

} // namespace patina
