// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/eval/eval_case.h"
#include "measure/eval/reference_case.h"
#include "reference/reference.h"

namespace patina {

/// Returns the library function that a case names. It is an error where there is none of that name
/// or it takes another number of arguments.
Result<const reference::Function*> findEvalFunction(const EvalCase& request);

/// Evaluates a case in double precision and returns its results: those of the block's function, for
/// a light its direction and then its radiance; a library function's out parameters follow what it
/// returns. It is an error where a block was added or changed since the program was built.
Result<std::vector<double>> evaluatedInDouble(const EvalCase& request);

/// Evaluates a case of a block whose code has been found.
std::vector<double> evaluatedInDouble(const EvalCase& request, const ReferenceCode& code);

} // namespace patina
