// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/environment_texture.h"

#include <algorithm>
#include <bit>

#include <epoxy/gl.h>

#include "render/binding.h"
#include "render/environment_units.h"

namespace patina {
namespace {

void bindTo(unsigned unit, const gl::Texture& texture) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glActiveTexture(GL_TEXTURE0);
}

/// Round the horizon and smooth; of the texture that is bound.
void makePanorama(GLint smallest) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, smallest);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
}

} // namespace

void EnvironmentTexture::fill(const EnvironmentTexels& texels) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    texture_ = gl::Texture::create(texels.size, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT,
                                   texels.halves.data());
    makePanorama(GL_LINEAR);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void EnvironmentTexture::fill(const EnvironmentTable& table) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    const glm::ivec2 size = table.textureSize();
    if (texture_.size() != size) {
        texture_ = gl::Texture::create(size, GL_RG32F, GL_RG, GL_FLOAT);
    }
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RG, GL_FLOAT,
                    table.texels().data());
    glBindTexture(GL_TEXTURE_2D, 0);
}

void EnvironmentTexture::bind(unsigned unit) const {
    bindTo(unit, texture_);
}

void SmallEnvironment::fit(glm::ivec2 size) {
    if (texture_.size() == size) {
        return;
    }
    texture_ = gl::Texture::create(size, GL_RGBA32F, GL_RGBA, GL_FLOAT);
    const auto longest = static_cast<unsigned>(std::max(size.x, size.y));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL,
                    static_cast<GLint>(std::bit_width(longest)) - 1);
    makePanorama(GL_LINEAR_MIPMAP_LINEAR);
    framebuffer_ = gl::Framebuffer::create();
    framebuffer_.attachColor(texture_);
    radiance_.assign(std::size_t(size.x) * std::size_t(size.y), glm::vec4(0.0f));
}

void SmallEnvironment::draw(const gl::Program& program, glm::ivec2 size) {
    fit(size);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, size.x, size.y);
    // The same state each time: a driver may compile a program anew for another one.
    for (const GLenum state : {GL_DEPTH_TEST, GL_BLEND, GL_DITHER, GL_CULL_FACE}) {
        glDisable(state);
    }
    program.use();
    noVertices_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, radiance_.data());
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glGenerateMipmap(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void SmallEnvironment::bind(unsigned unit) const {
    bindTo(unit, texture_);
}

namespace environment {

void assignUnits(const gl::Program& program) {
    program.bindSampler("environmentTable", binding::environmentTable);
    program.bindSampler("environmentImage", binding::environmentImage);
    program.bindSampler("environmentSmall", binding::environmentSmall);
    program.bindBlock("EnvironmentBlock", binding::environment);
}

} // namespace environment
} // namespace patina
