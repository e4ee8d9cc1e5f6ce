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
    /// The error is the driver's log as it came. A geometry stage, where there is one, stands
    /// between the two others.
    static tl::expected<Program, std::string> link(const Shader& vertex, const Shader& fragment,
                                                   const Shader* geometry = nullptr);

    /// Nothing when the driver does not take the binary (any more).
    static std::optional<Program> load(const ProgramBinary& binary);

    /// Nothing when the driver offers no binaries.
    std::optional<ProgramBinary> binary() const;

    /// Connects a uniform block to a binding point; nothing happens when the program lacks it.
    void bindBlock(const char* block, unsigned binding) const;

    /// Connects a sampler to a texture unit; nothing happens when the program lacks it.
    void bindSampler(const char* sampler, unsigned unit) const;

    /// Is -1 when the program lacks it.
    int uniform(const char* uniformName) const;

    void use() const;
    unsigned name() const { return name_.get(); }

  private:
    Name<deleteProgram> name_;
};

} // namespace patina::gl
