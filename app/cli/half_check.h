// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/long_work.h"
#include "measure/approximation/half_price.h"
#include "measure/approximation/half_terms.h"
#include "measure/approximation/half_timing.h"
#include "predict/gpu_family.h"

namespace patina {

/// Says what is told of a block with the lines that hold in floats of 16 bits, its mixed form.
struct HalfCheckWish {
    std::vector<const GpuFamily*> families; ///< are those that its cost is predicted for
    bool isTimed = false;                   ///< times it on the current graphics device
    bool hasText = false;                   ///< has the text of its program
};

/// Is what a mixed form costs.
struct MixedForm {
    std::vector<HalfPrice> prices;
    std::optional<Result<HalfTiming>> timing; ///< is of all lines that hold at once
    std::string text;                         ///< of its fragment stage
};

/// Predicts, times and writes what is wished for. Where it is stopped, what is not done is missing.
MixedForm mixedForm(const EvalCase& subject, const HalfReport& report, const HalfCheckWish& wish,
                    LongWork& work);

/// Returns which lines of a block survive floats of 16 bits and which break, as a table.
std::string halfText(const HalfReport& report, const std::string& name, const MixedForm& mixed);

nlohmann::json halfJson(const HalfReport& report, const std::string& name, const MixedForm& mixed);

} // namespace patina
