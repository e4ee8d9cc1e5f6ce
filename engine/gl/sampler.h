// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/name.h"

namespace patina::gl {

void deleteSampler(unsigned name);

/// Owns a sampler object, which says how a texture is filtered and repeated.
class Sampler {
  public:
    /// Makes a sampler. `wrap` is a GL constant for both directions. A smooth one filters linearly
    /// between texels and levels, and anisotropically where the driver can.
    static Sampler create(unsigned wrap, bool isSmooth);

    void bind(unsigned unit) const;

  private:
    Name<deleteSampler> name_;
};

} // namespace patina::gl
