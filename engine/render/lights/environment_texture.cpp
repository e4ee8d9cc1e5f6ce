// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/environment_texture.h"

#include <algorithm>

#include <epoxy/gl.h>
#include <glm/common.hpp>

#include "render/gpu/binding.h"
#include "render/gpu/environment_units.h"

namespace patina {
namespace {

void bindTo(unsigned unit, const gl::Texture& texture) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glActiveTexture(GL_TEXTURE0);
}

std::size_t area(glm::ivec2 size) {
    return std::size_t(size.x) * std::size_t(size.y);
}

/// half floats: 8 MiB of a picture, which take a few milliseconds
constexpr std::size_t halvesAtOnce = std::size_t(4) << 20;

/// Returns the size of the next coarser level.
glm::ivec2 halved(glm::ivec2 size) {
    return glm::max(size / 2, glm::ivec2(1));
}

/// Makes each texel of `coarse` the mean of the four (or two, in a single row) texels of `fine`
/// under it.
void halve(std::span<const glm::vec4> fine, glm::ivec2 fineSize, std::span<glm::vec4> coarse,
           glm::ivec2 size) {
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            glm::vec4 sum(0.0f);
            for (const glm::ivec2 corner : {glm::ivec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
                const glm::ivec2 from = glm::min(2 * glm::ivec2(x, y) + corner, fineSize - 1);
                sum += 0.25f * fine[std::size_t(from.y) * fineSize.x + from.x];
            }
            coarse[std::size_t(y) * size.x + x] = sum;
        }
    }
}

/// Makes the bound texture repeat around the horizon and filter linearly; `smallest` is the
/// minification filter.
void makePanorama(GLint smallest) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, smallest);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
}

} // namespace

void EnvironmentTexture::fill(const EnvironmentTexels& texels) {
    begin(texels.size);
    while (fillSome(texels)) {
    }
}

void EnvironmentTexture::begin(glm::ivec2 size) {
    texture_ = gl::Texture::create(size, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT);
    makePanorama(GL_LINEAR);
    glBindTexture(GL_TEXTURE_2D, 0);
    rows_ = 0;
}

bool EnvironmentTexture::fillSome(const EnvironmentTexels& texels) {
    const std::size_t inRow = std::size_t(4) * static_cast<std::size_t>(texels.size.x);
    const int maxRows = static_cast<int>(std::max<std::size_t>(halvesAtOnce / inRow, 1));
    const int count = std::min(maxRows, texels.size.y - rows_);
    if (count <= 0) {
        return false;
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, rows_, texels.size.x, count, GL_RGBA, GL_HALF_FLOAT,
                    &texels.halves[static_cast<std::size_t>(rows_) * inRow]);
    glBindTexture(GL_TEXTURE_2D, 0);
    rows_ += count;
    return true;
}

void EnvironmentTexture::fill(const EnvironmentTable& table) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    const glm::ivec2 size = table.textureSize();
    if (texture_.size() != size) {
        texture_ = gl::Texture::create(size, GL_RG32F, GL_RG, GL_FLOAT);
    }
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RG, GL_FLOAT, table.texels().data());
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
    GLint levels = 0;
    std::size_t texels = 0;
    for (glm::ivec2 level = size; level != glm::ivec2(1); texels += area(level)) {
        level = halved(level);
        glTexImage2D(GL_TEXTURE_2D, ++levels, GL_RGBA32F, level.x, level.y, 0, GL_RGBA, GL_FLOAT,
                     nullptr);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels);
    makePanorama(GL_LINEAR_MIPMAP_LINEAR);
    framebuffer_ = gl::Framebuffer::create();
    framebuffer_.attachColor(texture_);
    radiance_.assign(area(size), glm::vec4(0.0f));
    coarser_.assign(texels, glm::vec4(0.0f));
}

void SmallEnvironment::draw(const gl::Program& program, glm::ivec2 size) {
    fit(size);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, size.x, size.y);
    // The state is the same each time, since a driver may compile a program again for another one.
    for (const GLenum state : {GL_DEPTH_TEST, GL_BLEND, GL_DITHER, GL_CULL_FACE}) {
        glDisable(state);
    }
    program.use();
    noVertices_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, radiance_.data());
    fillCoarserLevels();
}

/// Computes the levels on the CPU, from what has been read back anyway: drivers that make levels by
/// drawing compile programs for it.
void SmallEnvironment::fillCoarserLevels() {
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    std::span<const glm::vec4> finer = radiance_;
    std::span<glm::vec4> room = coarser_;
    glm::ivec2 size = texture_.size();
    for (GLint level = 1; size != glm::ivec2(1); ++level) {
        const glm::ivec2 half = halved(size);
        const std::span<glm::vec4> texels = room.first(area(half));
        room = room.subspan(texels.size());
        halve(finer, size, texels, half);
        glTexSubImage2D(GL_TEXTURE_2D, level, 0, 0, half.x, half.y, GL_RGBA, GL_FLOAT,
                        texels.data());
        finer = texels;
        size = half;
    }
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
    program.bindSampler("environmentBlurred", binding::environmentBlurred);
    program.bindSampler("lobeTable", binding::lobeTable);
    program.bindBlock("EnvironmentBlock", binding::environment);
}

} // namespace environment
} // namespace patina
