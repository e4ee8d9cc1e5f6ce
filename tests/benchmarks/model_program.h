// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "catalog/catalog.h"
#include "catalog/parameter_layout.h"
#include "core/error.h"
#include "gl/program.h"

namespace patina::benchmarks {

/// A model, with values in place of its defaults, levels in place of the exact ones, and what fills
/// its first slot in place of the slot's own.
struct ModelChoice {
    const Block* model = nullptr;
    Values values;
    AccuracyLevels levels;
    const Block* filler = nullptr;
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
