// SPDX-License-Identifier: GPL-3.0-or-later
// Every test of this room fails where the driver found fault with a call; here is one that does.
#include "ui/gl_errors.h"

#include <epoxy/gl.h>

#include <QOffscreenSurface>
#include <QOpenGLContext>

namespace patina::tests::gl_errors_test {
namespace {

TEST(GlErrors, FaultyCall_IsHeard) {
    QOffscreenSurface surface;
    surface.create();
    QOpenGLContext context;
    ASSERT_TRUE(context.create() && context.makeCurrent(&surface));
    EXPECT_EQ(GlErrors::taken(), "");
    glEnable(GL_RGBA16F);
    EXPECT_NE(GlErrors::taken().find("GL_INVALID_ENUM"), std::string::npos);
    context.doneCurrent();
}

} // namespace
} // namespace patina::tests::gl_errors_test
