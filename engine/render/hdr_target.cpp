// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/hdr_target.h"

#include <algorithm>
#include <cstdint>

#include <epoxy/gl.h>
#include <fmt/format.h>

namespace patina {
namespace {

/// 8K UHD: with four samples that is 1.7 GB of graphics memory.
constexpr std::int64_t mostPixels = std::int64_t(7680) * 4320;

int driverLimit(GLenum name) {
    GLint limit = 0;
    glGetIntegerv(name, &limit);
    return limit;
}

Result<void> checkSize(glm::ivec2 size) {
    const int most =
        std::min(driverLimit(GL_MAX_TEXTURE_SIZE), driverLimit(GL_MAX_RENDERBUFFER_SIZE));
    const bool fits = size.x >= 1 && size.y >= 1 && size.x <= most && size.y <= most &&
                      std::int64_t(size.x) * size.y <= mostPixels;
    if (fits) {
        return {};
    }
    return failure(fmt::format("an image of {}x{} pixels cannot be drawn", size.x, size.y),
                   fmt::format("1 to {} pixels a side and at most {} million in all", most,
                               mostPixels / 1000000));
}

void forgetErrors() {
    while (glGetError() != GL_NO_ERROR) {
    }
}

} // namespace

Result<void> HdrTarget::fit(glm::ivec2 size, int samples) {
    if (size == size_ && samples == samples_) {
        return {};
    }
    if (auto checked = checkSize(size); !checked) {
        return checked;
    }
    *this = HdrTarget();
    const int offered = std::clamp(samples, 1, std::max(1, driverLimit(GL_MAX_SAMPLES)));
    Result<void> built = build(size, offered);
    if (!built && offered > 1) {
        built = build(size, 1);
    }
    if (built) {
        size_ = size;
        samples_ = samples;
    }
    return built;
}

Result<void> HdrTarget::build(glm::ivec2 size, int samples) {
    forgetErrors();
    color_ = gl::Renderbuffer::create(size, GL_RGBA16F, samples);
    depth_ = gl::Renderbuffer::create(size, GL_DEPTH_COMPONENT32F, samples);
    resolvedImage_ = gl::Texture::create(size, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        return failure(
            fmt::format("there is not enough graphics memory for {}x{} pixels", size.x, size.y));
    }
    framebuffer_ = gl::Framebuffer::create();
    framebuffer_.attachColor(color_);
    framebuffer_.attachDepth(depth_);
    resolvedFramebuffer_ = gl::Framebuffer::create();
    resolvedFramebuffer_.attachColor(resolvedImage_);
    const Result<void> drawable = framebuffer_.check();
    return drawable ? resolvedFramebuffer_.check() : drawable;
}

void HdrTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, size_.x, size_.y);
}

void HdrTarget::resolve() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolvedFramebuffer_.name());
    glBlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
}

} // namespace patina
