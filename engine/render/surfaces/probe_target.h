// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "core/error.h"
#include "gl/framebuffer.h"

namespace patina {

/// Is how many colours a program of the inspection writes: the picture's, then the terms.
inline constexpr int inspectionOutputs = 8;

/// Owns a target of 32-bit floats for the four pixels of a frame that are shaded together with one
/// pixel, so that its derivatives are those of the whole frame.
class ProbeTarget {
  public:
    using Outputs = std::array<glm::vec4, inspectionOutputs>;

    static Result<ProbeTarget> create();

    /// Binds and clears the target, to draw the part of a frame of `size` pixels around `pixel`,
    /// which is (0, 0) at the bottom left.
    void begin(glm::ivec2 size, glm::ivec2 pixel) const;

    /// Returns what the program wrote for the pixel.
    Outputs read(glm::ivec2 pixel) const;

  private:
    std::array<gl::Texture, inspectionOutputs> colors_;
    gl::Renderbuffer depth_;
    gl::Framebuffer framebuffer_;
};

} // namespace patina
