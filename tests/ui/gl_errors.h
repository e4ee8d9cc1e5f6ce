// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ios>
#include <string>

#include <gtest/gtest.h>

#include "support/program.h"

namespace patina::tests {

/// Fails each test in which the driver found fault with a call of OpenGL, in any context and thread
/// of the program. Mesa, which draws on the tests' X server, writes these to a file.
class GlErrors : public testing::EmptyTestEventListener {
  public:
    /// Begins to listen; the first context must not be made yet.
    GlErrors();

    /// Returns what the driver has written since the last call.
    static std::string taken();

    void OnTestEnd(const testing::TestInfo& test) override;

  private:
    static GlErrors* listening_;

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "gl-errors";
    std::streamoff taken_ = 0; ///< counts bytes
};

} // namespace patina::tests
