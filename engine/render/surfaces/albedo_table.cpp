// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surfaces/albedo_table.h"

#include <epoxy/gl.h>

#include "shading/program/surface_output.h"

namespace patina {

void AlbedoTable::fill(const Pipeline& pipeline) {
    const glm::ivec2 size = albedoTableShape(*pipeline.object.model->block).size;
    if (texture_.size() != size) {
        texture_ = gl::Texture::create(size, GL_RGBA32F, GL_RGBA, GL_FLOAT);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT); // azimuths are periodic
        framebuffer_ = gl::Framebuffer::create();
        framebuffer_.attachColor(texture_);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, size.x, size.y);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    pipeline.program->use();
    noVertices_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    pipeline_ = &pipeline;
}

void AlbedoTable::bind() const {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture_.name());
}

} // namespace patina
