// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/target_texture.h"

#include <algorithm>

#include <epoxy/gl.h>

namespace patina::gl {
namespace {

void makeSingle(glm::ivec2 size, unsigned internalFormat, int lastLevel) {
    const bool isDepth = internalFormat == GL_DEPTH_COMPONENT32F;
    for (int level = 0; level <= lastLevel; ++level) {
        glTexImage2D(GL_TEXTURE_2D, level, static_cast<GLint>(internalFormat),
                     std::max(size.x >> level, 1), std::max(size.y >> level, 1), 0,
                     isDepth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, nullptr);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, lastLevel);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                    lastLevel > 0 ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

} // namespace

TargetTexture TargetTexture::create(glm::ivec2 size, unsigned internalFormat, int samples) {
    if (samples <= 1) {
        return createLevels(size, internalFormat, 0);
    }
    TargetTexture texture;
    GLuint name = 0;
    glGenTextures(1, &name);
    texture.name_ = Name<deleteTexture>(name);
    texture.target_ = GL_TEXTURE_2D_MULTISAMPLE;
    glBindTexture(texture.target_, name);
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, internalFormat, size.x, size.y,
                            GL_TRUE);
    glBindTexture(texture.target_, 0);
    return texture;
}

TargetTexture TargetTexture::createLevels(glm::ivec2 size, unsigned internalFormat, int lastLevel) {
    TargetTexture texture;
    GLuint name = 0;
    glGenTextures(1, &name);
    texture.name_ = Name<deleteTexture>(name);
    texture.target_ = GL_TEXTURE_2D;
    glBindTexture(GL_TEXTURE_2D, name);
    makeSingle(size, internalFormat, lastLevel);
    glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

void TargetTexture::showLevels(int lastLevel) const {
    glBindTexture(target_, name());
    glTexParameteri(target_, GL_TEXTURE_MAX_LEVEL, lastLevel);
}

void TargetTexture::bind(unsigned unit) const {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(target_, name());
}

} // namespace patina::gl
