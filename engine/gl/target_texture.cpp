// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/target_texture.h"

#include <epoxy/gl.h>

namespace patina::gl {
namespace {

void makeSingle(glm::ivec2 size, unsigned internalFormat) {
    const bool isDepth = internalFormat == GL_DEPTH_COMPONENT32F;
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), size.x, size.y, 0,
                 isDepth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

} // namespace

TargetTexture TargetTexture::create(glm::ivec2 size, unsigned internalFormat, int samples) {
    TargetTexture texture;
    GLuint name = 0;
    glGenTextures(1, &name);
    texture.name_ = Name<deleteTexture>(name);
    texture.target_ = samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    glBindTexture(texture.target_, name);
    if (samples > 1) {
        glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, internalFormat, size.x, size.y,
                                GL_TRUE);
    } else {
        makeSingle(size, internalFormat);
    }
    glBindTexture(texture.target_, 0);
    return texture;
}

void TargetTexture::bind(unsigned unit) const {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(target_, name());
}

} // namespace patina::gl
