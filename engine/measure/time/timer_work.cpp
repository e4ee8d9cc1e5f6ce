// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/time/timer_work.h"

#include <epoxy/gl.h>

namespace patina {
namespace {

constexpr int largeSide = 128;
constexpr int smallSide = 96;

void copy(const gl::Framebuffer& from, int fromSide, const gl::Framebuffer& to, int toSide) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.name());
    glBlitFramebuffer(0, 0, fromSide, fromSide, 0, 0, toSide, toSide, GL_COLOR_BUFFER_BIT,
                      GL_LINEAR);
}

} // namespace

TimerWork::TimerWork()
    : large_(gl::Texture::create({largeSide, largeSide}, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT)),
      small_(gl::Texture::create({smallSide, smallSide}, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT)) {
    largeFramebuffer_.attachColor(large_);
    smallFramebuffer_.attachColor(small_);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void TimerWork::run(int rounds) const {
    for (int i = 0; i < rounds; ++i) {
        copy(largeFramebuffer_, largeSide, smallFramebuffer_, smallSide);
        copy(smallFramebuffer_, smallSide, largeFramebuffer_, largeSide);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

} // namespace patina
