// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "gl/program.h"

namespace patina {

/// Is one program binary on disk. The file is named after the program's hash and the current
/// context's driver, repeats both, and carries a checksum; one that is truncated, damaged or from
/// another driver reads as if it were missing.
class ProgramFile {
  public:
    /// Names the file of a program. With an empty `folder` nothing is ever read or written.
    ProgramFile(const std::filesystem::path& folder, const std::string& hash);

    std::optional<gl::ProgramBinary> read() const;

    /// Writes the file atomically. It fails silently: the program is compiled again next time. The
    /// oldest files are removed when the folder holds more than 1000.
    void write(const gl::ProgramBinary& binary) const;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    std::string key_;
};

} // namespace patina
