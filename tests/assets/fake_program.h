// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <filesystem>

#include "assets/asset_client.h"

namespace patina::tests {

/// Makes the files process misbehave in the named manner while the object lives; see
/// fake_files.cpp.
class FakeProgram {
  public:
    explicit FakeProgram(const char* behaviour) { ::setenv("PATINA_FAKE", behaviour, 1); }
    ~FakeProgram() { ::unsetenv("PATINA_FAKE"); }
    FakeProgram(const FakeProgram&) = delete;
    FakeProgram& operator=(const FakeProgram&) = delete;

    static AssetClient::Options options(double waitLimitSeconds = 20.0) {
        AssetClient::Options options;
        options.program = std::filesystem::path(PATINA_BINARY_DIR) / "bin" / "patina-fake-files";
        options.waitLimitSeconds = waitLimitSeconds;
        return options;
    }
};

} // namespace patina::tests
