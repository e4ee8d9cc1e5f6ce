// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "gl/name.h"

namespace patina::gl {

void deleteShader(unsigned name);

/// Owns one compiled stage of a program.
class Shader {
  public:
    /// Compiles GLSL text. `stage` is GL_VERTEX_SHADER and the like. The error is the driver's log,
    /// unchanged.
    static tl::expected<Shader, std::string> compile(unsigned stage, std::string_view source);

    unsigned name() const { return name_.get(); }

  private:
    Name<deleteShader> name_;
};

} // namespace patina::gl
