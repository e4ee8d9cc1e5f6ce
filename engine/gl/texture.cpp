// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/texture.h"

#include <epoxy/gl.h>

namespace patina::gl {

void deleteTexture(unsigned name) {
    glDeleteTextures(1, &name);
}

Texture Texture::create(glm::ivec2 size, unsigned internalFormat, unsigned format, unsigned type,
                        const void* texels) {
    Texture texture;
    GLuint name = 0;
    glGenTextures(1, &name);
    texture.name_ = Name<deleteTexture>(name);
    texture.size_ = size;
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), size.x, size.y, 0, format,
                 type, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

} // namespace patina::gl
