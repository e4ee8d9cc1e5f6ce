// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/name.h"

namespace patina::gl {

void deleteSampler(unsigned name);

/// Tells how a texture is read, apart from the texture itself.
class Sampler {
  public:
    /// `wrap` is a GL constant for both directions. Smooth ones blend texels and smaller versions,
    /// in the direction of the longer side of a pixel's footprint where the driver can.
    static Sampler create(unsigned wrap, bool isSmooth);

    void bind(unsigned unit) const;

  private:
    Name<deleteSampler> name_;
};

} // namespace patina::gl
