// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/accumulation.h"

#include <array>
#include <string>

#include <epoxy/gl.h>

namespace patina {

Result<void> Accumulation::prepare(const Catalog& catalog, ProgramCache& cache) {
    if (program_) {
        return {};
    }
    const std::array<std::string, 1> files{"passes/accumulate.frag"};
    const auto source = passProgram(catalog, "passes/screen.vert", files);
    if (!source) {
        return tl::unexpected(source.error().front());
    }
    const ProgramCache::Found found = cache.get(*source);
    if (!found.program) {
        return tl::unexpected(found.errors.front());
    }
    program_ = found.program;
    return {};
}

Result<bool> Accumulation::fit(glm::ivec2 size, const Catalog& catalog, ProgramCache& cache) {
    if (auto prepared = prepare(catalog, cache); !prepared) {
        return tl::unexpected(prepared.error());
    }
    if (mean_.size() == size) {
        return true;
    }
    mean_ = gl::Texture::create(size, GL_RGBA32F, GL_RGBA, GL_FLOAT);
    framebuffer_ = gl::Framebuffer::create();
    framebuffer_.attachColor(mean_);
    if (auto drawable = framebuffer_.check(); !drawable) {
        mean_ = gl::Texture();
        return tl::unexpected(drawable.error());
    }
    return false;
}

void Accumulation::add(const gl::Texture& frame, float share) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, mean_.size().x, mean_.size().y);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_DITHER);
    // Computes mean + share (frame - mean); a share of 1 does not read the undefined mean.
    (share < 1.0f ? glEnable : glDisable)(GL_BLEND);
    glBlendColor(0.0f, 0.0f, 0.0f, share);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    program_->use();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, frame.name());
    noVertices_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    glBindVertexArray(0);
}

} // namespace patina
