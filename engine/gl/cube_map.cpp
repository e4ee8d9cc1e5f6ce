// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/cube_map.h"

#include <epoxy/gl.h>

namespace patina::gl {

CubeMap CubeMap::create(int width, unsigned internalFormat) {
    CubeMap map;
    GLuint name = 0;
    glGenTextures(1, &name);
    map.name_ = Name<deleteTexture>(name);
    map.width_ = width;
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glBindTexture(GL_TEXTURE_CUBE_MAP, name);
    for (int size = width; size > 0; size /= 2) {
        for (GLenum face = 0; face < 6; ++face) {
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, map.levels_,
                         static_cast<GLint>(internalFormat), size, size, 0, GL_RGBA, GL_FLOAT,
                         nullptr);
        }
        ++map.levels_;
    }
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, map.levels_ - 1);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glBindTexture(GL_TEXTURE_CUBE_MAP, 0);
    return map;
}

void CubeMap::showLevels(int first, int last) const {
    glBindTexture(GL_TEXTURE_CUBE_MAP, name());
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BASE_LEVEL, first);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, last);
    glBindTexture(GL_TEXTURE_CUBE_MAP, 0);
}

void CubeMap::bind(unsigned unit) const {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_CUBE_MAP, name());
    glActiveTexture(GL_TEXTURE0);
}

} // namespace patina::gl
