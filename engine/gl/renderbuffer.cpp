// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/renderbuffer.h"

#include <epoxy/gl.h>

namespace patina::gl {

void deleteRenderbuffer(unsigned name) {
    glDeleteRenderbuffers(1, &name);
}

Renderbuffer Renderbuffer::create(glm::ivec2 size, unsigned internalFormat, int samples) {
    Renderbuffer buffer;
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    buffer.name_ = Name<deleteRenderbuffer>(name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, internalFormat,
                                     size.x, size.y);
    return buffer;
}

} // namespace patina::gl
