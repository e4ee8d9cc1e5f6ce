// SPDX-License-Identifier: GPL-3.0-or-later
// A machine whose driver has no OpenGL 4.1.
#include <gtest/gtest.h>

#include "support/program.h"

namespace patina::tests::missing_opengl_test {
namespace {

TEST(MissingOpenGl, OfTheEditor_IsToldAndEndsItWithStatusOne) {
    const TemporaryFolder home;
    Start start{.arguments = {},
                .environment = {{"MESA_GL_VERSION_OVERRIDE", "3.3"}},
                .input = {},
                .timeLimitSeconds = 60.0};
    for (const char* name :
         {"XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"}) {
        start.environment[name] = (home / name).string();
    }
    const Outcome outcome = run(PATINA_BINARY_DIR "/bin/patina", start);
    EXPECT_EQ(outcome.exitCode, 1) << outcome.err;
    EXPECT_NE(outcome.err.find("OpenGL 4.1"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace patina::tests::missing_opengl_test
