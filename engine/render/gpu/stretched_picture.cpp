// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/stretched_picture.h"

#include <array>
#include <string>

#include <epoxy/gl.h>

#include "gl/vertex_array.h"
#include "shading/program/program_source.h"

namespace patina {
namespace {

void stretch(unsigned from, glm::ivec2 size, unsigned to, glm::ivec2 newSize) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, newSize.x, newSize.y, GL_COLOR_BUFFER_BIT,
                      size == newSize ? GL_NEAREST : GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, to);
}

} // namespace

StretchedPicture::StretchedPicture(glm::ivec2 size)
    : size_(size), image_(gl::Texture::create(size, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE)),
      kept_(gl::Framebuffer::create()) {
    kept_.attachColor(image_);
}

void StretchedPicture::take(unsigned framebuffer) {
    stretch(framebuffer, size_, kept_.name(), size_);
}

void StretchedPicture::show(unsigned framebuffer, glm::ivec2 size) const {
    stretch(kept_.name(), size_, framebuffer, size);
}

Checked<void> StretchedPicture::draw(unsigned framebuffer, glm::ivec2 size, const Catalog& catalog,
                                     ProgramCache& cache) const {
    const std::array<std::string, 1> files{"passes/stretched.frag"};
    const auto source = passProgram(catalog, "passes/screen.vert", files);
    if (!source) {
        return tl::unexpected(source.error());
    }
    const ProgramCache::Found found = cache.get(*source);
    if (!found.program) {
        return tl::unexpected(found.errors);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size.x, size.y);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_DITHER);
    glDisable(GL_FRAMEBUFFER_SRGB);
    found.program->use();
    glUniform2f(found.program->uniform("newSize"), float(size.x), float(size.y));
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, image_.name());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    const gl::VertexArray noVertices = gl::VertexArray::create();
    noVertices.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    return {};
}

} // namespace patina
