// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/texture_array.h"

#include <epoxy/gl.h>

namespace patina::gl {

TextureArray TextureArray::create(glm::ivec2 size, int layers, unsigned internalFormat) {
    return create(size, layers, internalFormat, GL_DEPTH_COMPONENT);
}

TextureArray TextureArray::createColors(glm::ivec2 size, int layers, unsigned internalFormat) {
    return create(size, layers, internalFormat, GL_RGBA);
}

TextureArray TextureArray::create(glm::ivec2 size, int layers, unsigned internalFormat,
                                  unsigned format) {
    TextureArray texture;
    GLuint name = 0;
    glGenTextures(1, &name);
    texture.name_ = Name<deleteTexture>(name);
    texture.size_ = size;
    texture.layers_ = layers;
    glBindTexture(GL_TEXTURE_2D_ARRAY, name);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(internalFormat), size.x, size.y, layers,
                 0, format, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    return texture;
}

} // namespace patina::gl
