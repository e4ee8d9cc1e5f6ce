// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "catalog/catalog.h"
#include "core/error.h"
#include "gl/program.h"

namespace patina::benchmarks {

/// A model, and values in place of its defaults.
struct ModelChoice {
    const Block* model = nullptr;
    Values values;
};

/// A program that shades a target with one model and nothing else. Its
/// context must be current whenever it is made, used or destroyed.
class ModelProgram {
  public:
    /// With the model's own file, or with `textbook` in its place: the same function, written as
    /// books print it, from the global vectors N, T, B, L and V.
    static Checked<ModelProgram> link(const Catalog& catalog, const ModelChoice& choice,
                                      const std::filesystem::path& textbook = {});

    /// The vectors alone: what every other program pays as well.
    static Checked<ModelProgram> linkEmpty(const Catalog& catalog);

    /// Seconds per pixel of the bound framebuffer, by the clock around glFinish.
    double secondsPerPixel(int frames) const;

    static constexpr int targetSize = 512;

  private:
    explicit ModelProgram(gl::Program program) : program_(std::move(program)) {}

    gl::Program program_;
};

} // namespace patina::benchmarks
