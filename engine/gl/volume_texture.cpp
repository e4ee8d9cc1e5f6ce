// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/volume_texture.h"

#include <epoxy/gl.h>

namespace patina::gl {

VolumeTexture VolumeTexture::create(const glm::ivec3& size, const float* texels) {
    VolumeTexture texture;
    GLuint name = 0;
    glGenTextures(1, &name);
    texture.name_ = Name<deleteTexture>(name);
    glBindTexture(GL_TEXTURE_3D, name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB32F, size.x, size.y, size.z, 0, GL_RGB, GL_FLOAT, texels);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTexParameteri(GL_TEXTURE_3D, axis, GL_CLAMP_TO_EDGE);
    }
    glBindTexture(GL_TEXTURE_3D, 0);
    return texture;
}

} // namespace patina::gl
