// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of widgets send real mouse and key events to windows on an X server of their own. Without
// one they fail: a skipped test proves nothing.
#include <cstdlib>
#include <iostream>
#include <memory>

#include <QApplication>
#include <gtest/gtest.h>

#include "trial/trial_gate.h"
#include "ui/gl_errors.h"
#include "ui/virtual_display.h"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    if (testing::GTEST_FLAG(list_tests)) {
        return RUN_ALL_TESTS();
    }
    const patina::tests::VirtualDisplay display;
    if (display.name().empty()) {
        std::cerr << "Xvfb could not be started; install it to test the editor\n";
        return EXIT_FAILURE;
    }
    setenv("DISPLAY", display.name().c_str(), 1);
    setenv("QT_QPA_PLATFORM", "xcb", 1);
    unsetenv("WAYLAND_DISPLAY");
    testing::UnitTest::GetInstance()->listeners().Append(new patina::tests::GlErrors);
    patina::setBlockGate(std::make_shared<patina::TrialGate>(
        patina::TrialGate::Options{.program = PATINA_BINARY_DIR "/bin/patina",
                                   .limits = {.memoryBytes = std::size_t(1) << 30}}));
    patina::neverWaitForTrialsHere();
    QApplication application(argc, argv);
    QApplication::setStyle("Fusion");
    return RUN_ALL_TESTS();
}
