// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "measure/eval/eval_case.h"

namespace patina {

/// Holds a case, or what is wrong with it. `id` is null where it could not be read.
struct EvalLine {
    nlohmann::json id;
    Result<EvalCase> request;
};

/// Reads one line of what `patina eval` is given. Parameters that are not given have their
/// defaults; one that is unknown, of the wrong type or outside its range is an error.
EvalLine readEvalLine(std::string_view line, const Catalog& catalog);

} // namespace patina
