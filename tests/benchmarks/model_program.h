// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "catalog/catalog.h"
#include "catalog/parameter_layout.h"
#include "core/error.h"
#include "gl/program.h"

namespace patina::benchmarks {

/// Chooses a model, and replaces its defaults by values, its exact levels by others, and the
/// default of its first slot by a filler.
struct ModelChoice {
    const Block* model = nullptr;
    Values values;
    AccuracyLevels levels;
    const Block* filler = nullptr;
};

/// Is a program that shades a target with one model and nothing else. Its context must be current
/// whenever it is made, used or destroyed.
class ModelProgram {
  public:
    /// Links a program with the model's own file, or with `textbook` instead: the same function,
    /// written as books print it, from the global vectors N, T, B, L and V.
    static Checked<ModelProgram> link(const Catalog& catalog, const ModelChoice& choice,
                                      const std::filesystem::path& textbook = {});

    /// Links a program that computes only the vectors, which every other program does as well.
    static Checked<ModelProgram> linkEmpty(const Catalog& catalog);

    /// Returns seconds per pixel of the bound framebuffer, by the clock around glFinish.
    double secondsPerPixel(int frames) const;

    static constexpr int targetSize = 512;

  private:
    explicit ModelProgram(gl::Program program) : program_(std::move(program)) {}

    gl::Program program_;
};

} // namespace patina::benchmarks
