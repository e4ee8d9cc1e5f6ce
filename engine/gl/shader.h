// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "gl/name.h"

namespace patina::gl {

void deleteShader(unsigned name);

/// Represents one compiled stage. `stage` is GL_VERTEX_SHADER and the like.
class Shader {
  public:
    /// The error is the driver's log as it came.
    static tl::expected<Shader, std::string> compile(unsigned stage, std::string_view source);

    unsigned name() const { return name_.get(); }

  private:
    Name<deleteShader> name_;
};

} // namespace patina::gl
