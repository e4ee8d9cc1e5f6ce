// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "measure/approximation/measured_text.h"
#include "measure/choice/choices.h"
#include "predict/gpu_family.h"

namespace patina {

/// Is a combination of the levels that a block's author declared.
struct DeclaredWay {
    AccuracyLevels levels; ///< are those that are not exact
    TextError error;       ///< is that against the exact text in double precision
    double cost = 0.0;     ///< is in the unit of ShaderPrice
};

/// Judges all combinations of a block's declared levels as found ways are: by their largest error
/// on `cases` common cases that a search does not see, and by their predicted cost. Those that
/// cannot be evaluated or compiled are left out. It is an error where the block itself cannot be.
Checked<std::vector<DeclaredWay>> declaredWays(const EvalCase& subject,
                                               const std::filesystem::path& shaders,
                                               const GpuFamily& family, const CaseWish& cases,
                                               const std::function<bool()>& isStopped);

} // namespace patina
