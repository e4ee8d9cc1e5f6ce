// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "gl/name.h"
#include "gl/shader.h"

namespace patina::gl {

void deleteProgram(unsigned name);

/// Holds a linked program as the driver stores it.
struct ProgramBinary {
    unsigned format = 0;
    std::vector<std::byte> bytes;
};

/// Owns a linked program.
class Program {
  public:
    /// Links the stages; `geometry` may be null. The error is the driver's log, unchanged.
    static tl::expected<Program, std::string> link(const Shader& vertex, const Shader& fragment,
                                                   const Shader* geometry = nullptr);

    /// Returns nothing when the driver does not accept the binary, for example after an update.
    static std::optional<Program> load(const ProgramBinary& binary);

    /// Returns nothing when the driver offers no binaries.
    std::optional<ProgramBinary> binary() const;

    /// Connects a uniform block to a binding point; does nothing when the program has no such
    /// block.
    void bindBlock(const char* block, unsigned binding) const;

    /// Connects a sampler to a texture unit; does nothing when the program has no such sampler.
    void bindSampler(const char* sampler, unsigned unit) const;

    /// Returns the location of a uniform; -1 when the program has none of this name.
    int uniform(const char* uniformName) const;

    void use() const;
    unsigned name() const { return name_.get(); }

  private:
    Name<deleteProgram> name_;
};

} // namespace patina::gl
