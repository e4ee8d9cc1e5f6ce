// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "core/error.h"
#include "gl/program.h"
#include "shading/program/program_source.h"

namespace patina {

/// Finds programs by the hash of their text, in memory and as binaries in a folder. It belongs to
/// one context. Nothing is compiled twice, not even what did not compile.
class ProgramCache {
  public:
    struct Found {
        std::shared_ptr<const gl::Program> program; ///< is null when it does not compile
        Errors errors;         ///< say why it does not compile, at the files' own lines
        bool compiled = false; ///< this call compiled it
        bool isFinal = true;   ///< false: a block in it is still being tried (see BlockGate)
    };

    /// Keeps binaries in `folder`, which is created when it is missing; when it is empty, nothing
    /// is kept on disk. A folder that cannot be written to costs only the time to compile.
    explicit ProgramCache(std::filesystem::path folder);

    Found get(const ProgramSource& source);

    /// Returns how many programs were compiled since the start.
    int compiledCount() const { return compiledCount_; }

    /// Returns how many programs were built since the start: compiled, also without success, or
    /// loaded from the disk.
    int builtCount() const { return static_cast<int>(found_.size()); }

  private:
    Found build(const ProgramSource& source, const std::string& hash);

    std::filesystem::path folder_;
    std::map<std::string, Found> found_;
    int compiledCount_ = 0;
};

/// Compiles and links a program; the errors are at the files' own lines.
Checked<gl::Program> compileProgram(const ProgramSource& source);

} // namespace patina
