// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "core/error.h"
#include "predict/compile_request.h"
#include "vulkan/spirv_program.h"

namespace patina {

/// Compiles for one of ARM's Mali cores with `malioc`.
class MaliCore {
  public:
    /// Makes one for a core such as "Mali-G78". It is an error where malioc is missing or does not
    /// know the core.
    static Result<MaliCore> create(const std::string& core);

    /// Returns malioc's name and version.
    const std::string& compiler() const { return compiler_; }

    /// Compiles the fragment stage; nothing is known of the vertex stage. It changes TMPDIR in this
    /// process' environment to a folder that is gone when it returns, because malioc writes files
    /// of fixed names there.
    Result<PipelineStatistics> compile(const SpirvProgram& program) const;

  private:
    MaliCore(std::string core, std::string compiler, std::filesystem::path temporary);

    std::string core_;
    std::string compiler_;
    std::filesystem::path temporary_; ///< is the system's folder for temporary files
};

} // namespace patina
