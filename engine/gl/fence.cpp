// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/fence.h"

#include <algorithm>

#include <epoxy/gl.h>

namespace patina::gl {

Fence Fence::afterCommandsSoFar() {
    Fence fence;
    fence.sync_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush();
    return fence;
}

Fence::~Fence() {
    glDeleteSync(static_cast<GLsync>(sync_)); // does nothing without one
}

bool Fence::passed(std::chrono::nanoseconds patience) {
    if (sync_ == nullptr) {
        return true;
    }
    const auto wait = std::max(patience, std::chrono::nanoseconds::zero()).count();
    const GLenum state =
        glClientWaitSync(static_cast<GLsync>(sync_), 0, static_cast<GLuint64>(wait));
    if (state == GL_TIMEOUT_EXPIRED) {
        return false;
    }
    *this = Fence(); // also when waiting failed: whatever is drawn next waits by itself
    return true;
}

void Fence::holdBack() const {
    if (sync_ != nullptr) {
        glWaitSync(static_cast<GLsync>(sync_), 0, GL_TIMEOUT_IGNORED);
    }
}

} // namespace patina::gl
