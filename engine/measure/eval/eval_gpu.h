// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "measure/eval/eval_case.h"

namespace patina {

/// Evaluates cases by the real shader code in a headless OpenGL context, which is made for the
/// first case and kept. Cases that need the same program are drawn together, in one pixel or a few
/// each.
class EvalGpu {
  public:
    EvalGpu();
    ~EvalGpu();

    /// Returns the results of each case, in the order of evaluatedInDouble(), or why there are
    /// none.
    std::vector<Result<std::vector<double>>> evaluate(std::span<const EvalCase> cases,
                                                      const Catalog& catalog);

  private:
    class Device;
    Result<Device*> device();

    std::unique_ptr<Device> device_;
};

} // namespace patina
