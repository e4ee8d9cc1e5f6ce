// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/screen_picture.h"

#include <array>

#include <epoxy/gl.h>

#include "gl/vertex_array.h"
#include "shading/program/program_source.h"

namespace patina {

PicturePart wholePicture(const ScreenTarget& target) {
    return {1.0f / glm::vec2(target.size), glm::vec2(0.0f)};
}

Checked<void> drawPicture(const gl::Texture& picture, const PicturePart& part,
                          const ScreenTarget& target, bool isBlended, const Catalog& catalog,
                          ProgramCache& cache) {
    const std::array<std::string, 1> files{"passes/screen_picture.frag"};
    const auto source = passProgram(catalog, "passes/screen.vert", files);
    if (!source) {
        return tl::unexpected(source.error());
    }
    const ProgramCache::Found found = cache.get(*source);
    if (!found.program) {
        return tl::unexpected(found.errors);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(0, 0, target.size.x, target.size.y);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_DITHER);
    glDisable(GL_FRAMEBUFFER_SRGB);
    if (isBlended) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    } else {
        glDisable(GL_BLEND);
    }
    found.program->use();
    glUniform4f(found.program->uniform("part"), part.scale.x, part.scale.y, part.offset.x,
                part.offset.y);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, picture.name());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    const gl::VertexArray noVertices = gl::VertexArray::create();
    noVertices.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glDisable(GL_BLEND);
    return {};
}

void OverlayPicture::take(glm::ivec2 size, const unsigned char* pixels) {
    if (pixels == nullptr) {
        image_ = {};
    } else if (image_.name() != 0 && image_.size() == size) {
        glBindTexture(GL_TEXTURE_2D, image_.name());
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_BGRA,
                        GL_UNSIGNED_INT_8_8_8_8_REV, pixels);
    } else {
        image_ = gl::Texture::create(size, GL_RGBA8, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, pixels);
    }
}

Checked<void> OverlayPicture::draw(const ScreenTarget& target, const Catalog& catalog,
                                   ProgramCache& cache) const {
    PicturePart fromTheTop = wholePicture(target);
    fromTheTop.scale.y *= -1.0f;
    fromTheTop.offset.y = 1.0f;
    return drawPicture(image_, fromTheTop, target, true, catalog, cache);
}

} // namespace patina
