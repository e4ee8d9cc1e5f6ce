// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/hdr_target.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <glm/common.hpp>

namespace patina {
namespace {

/// Is 8K UHD, which takes 1.7 GB of graphics memory with four samples.
constexpr std::int64_t maxPixels = std::int64_t(7680) * 4320;

int driverLimit(GLenum name) {
    GLint limit = 0;
    glGetIntegerv(name, &limit);
    return limit;
}

void forgetErrors() {
    while (glGetError() != GL_NO_ERROR) {
    }
}

/// Returns 2 where four drawn pixels per averaged pixel are no more than `samples` and the driver
/// can draw such an image, else 1.
int finenessFor(glm::ivec2 size, int samples) {
    const int maxSide =
        std::min(driverLimit(GL_MAX_TEXTURE_SIZE), driverLimit(GL_MAX_RENDERBUFFER_SIZE));
    return samples >= 4 && 2 * std::max(size.x, size.y) <= maxSide ? 2 : 1;
}

glm::ivec2 scaledSize(glm::ivec2 size, double scale) {
    return glm::clamp(glm::ivec2(glm::round(scale * glm::dvec2(size))), glm::ivec2(1), size);
}

gl::Texture linearImage(glm::ivec2 size, HdrNumbers numbers) {
    const bool isFull = numbers == HdrNumbers::Full;
    return gl::Texture::create(size, isFull ? GL_RGBA32F : GL_RGBA16F, GL_RGBA,
                               isFull ? GL_FLOAT : GL_HALF_FLOAT);
}

} // namespace

Result<void> checkPictureSize(glm::ivec2 size) {
    const int maxSide =
        std::min(driverLimit(GL_MAX_TEXTURE_SIZE), driverLimit(GL_MAX_RENDERBUFFER_SIZE));
    const bool fits = size.x >= 1 && size.y >= 1 && size.x <= maxSide && size.y <= maxSide &&
                      std::int64_t(size.x) * size.y <= maxPixels;
    if (fits) {
        return {};
    }
    return failure(fmt::format("an image of {}x{} pixels cannot be drawn", size.x, size.y),
                   fmt::format("1 to {} pixels a side and at most {} million in all", maxSide,
                               maxPixels / 1000000));
}

Result<bool> HdrTarget::fit(glm::ivec2 size, int samples, bool dense, HdrNumbers numbers,
                            double scale, bool isReadBetween) {
    const glm::ivec2 scaled = scaledSize(size, scale);
    const Shape wanted{size, scaled, samples, dense ? 2 : 1, numbers, isReadBetween};
    if (wanted == wanted_) {
        return false;
    }
    if (auto checked = checkPictureSize(size); !checked) {
        return tl::unexpected(checked.error());
    }
    *this = HdrTarget();
    const int fineness = dense ? finenessFor(scaled, samples) : 1;
    const int offered = std::clamp(samples, 1, std::max(1, driverLimit(GL_MAX_SAMPLES)));
    Result<void> built =
        build({size, scaled, fineness > 1 ? 1 : offered, fineness, numbers, isReadBetween});
    if (!built && (offered > 1 || fineness > 1)) {
        built = build({size, scaled, 1, 1, numbers, isReadBetween});
    }
    if (!built) {
        return tl::unexpected(built.error());
    }
    wanted_ = wanted;
    return true;
}

Result<void> HdrTarget::build(const Shape& shape) {
    forgetErrors();
    built_ = shape;
    const glm::ivec2 drawn = drawnSize();
    const GLenum format = shape.numbers == HdrNumbers::Full ? GL_RGBA32F : GL_RGBA16F;
    color_ = shape.isAveraged() ? gl::Renderbuffer::create(drawn, format, shape.samples)
                                : gl::Renderbuffer();
    depth_ = gl::Renderbuffer::create(drawn, GL_DEPTH_COMPONENT32F, shape.samples);
    resolvedImage_ = linearImage(shape.scaled, shape.numbers);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        return failure(fmt::format("there is not enough graphics memory for {}x{} pixels",
                                   shape.size.x, shape.size.y));
    }
    attachAll();
    const Result<void> drawable = framebuffer_.check();
    if (!drawable || shape.isStretched()) {
        return drawable ? buildStretched() : drawable;
    }
    return resolvedFramebuffer_.check();
}

void HdrTarget::attachAll() {
    framebuffer_ = gl::Framebuffer::create();
    if (built_.isAveraged()) {
        framebuffer_.attachColor(color_);
    } else {
        framebuffer_.attachColor(resolvedImage_);
    }
    framebuffer_.attachDepth(depth_);
    resolvedFramebuffer_ = gl::Framebuffer::create();
    resolvedFramebuffer_.attachColor(resolvedImage_);
}

Result<void> HdrTarget::buildStretched() {
    stretchedImage_ = linearImage(built_.size, built_.numbers);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        return failure(fmt::format("there is not enough graphics memory for {}x{} pixels",
                                   built_.size.x, built_.size.y));
    }
    stretchedFramebuffer_ = gl::Framebuffer::create();
    stretchedFramebuffer_.attachColor(stretchedImage_);
    const Result<void> drawable = resolvedFramebuffer_.check();
    return drawable ? stretchedFramebuffer_.check() : drawable;
}

PixelSampling HdrTarget::sampling() const {
    GLint samples = 0;
    glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &samples);
    return {std::max(samples, 1), built_.fineness};
}

void HdrTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, drawnSize().x, drawnSize().y);
}

void HdrTarget::resolve() const {
    if (!built_.isAveraged()) {
        return;
    }
    const glm::ivec2 drawn = drawnSize();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolvedFramebuffer_.name());
    // Two to one, a linear filter reads at the corner where four pixels meet: their mean.
    glBlitFramebuffer(0, 0, drawn.x, drawn.y, 0, 0, built_.scaled.x, built_.scaled.y,
                      GL_COLOR_BUFFER_BIT, built_.fineness > 1 ? GL_LINEAR : GL_NEAREST);
}

void HdrTarget::stretch() const {
    if (!built_.isStretched()) {
        return;
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolvedFramebuffer_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, stretchedFramebuffer_.name());
    glBlitFramebuffer(0, 0, built_.scaled.x, built_.scaled.y, 0, 0, built_.size.x, built_.size.y,
                      GL_COLOR_BUFFER_BIT, GL_LINEAR);
}

void HdrTarget::keepResolved() {
    HdrTarget kept;
    kept.built_ = built_;
    if (built_.isStretched()) {
        kept.stretchedImage_ = std::move(stretchedImage_);
        kept.stretchedFramebuffer_ = std::move(stretchedFramebuffer_);
    } else {
        kept.resolvedImage_ = std::move(resolvedImage_);
        kept.resolvedFramebuffer_ = std::move(resolvedFramebuffer_);
    }
    *this = std::move(kept);
}

} // namespace patina
