// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/eval/eval_case.h"
#include "measure/eval/reference_case.h"
#include "reference/reference.h"

namespace patina {

/// Returns the library function that a case names; an error when there is none of that name or it
/// takes another number of arguments.
Result<const reference::Function*> findEvalFunction(const EvalCase& request);

/// Returns the numbers that answer a case, in double precision: what the function of the block
/// returns, of a light its direction and then its radiance; of the library's functions also their
/// out parameters behind it. Blocks that were not there when the program was built, or have changed
/// since, are an error.
Result<std::vector<double>> evaluatedInDouble(const EvalCase& request);

/// The same for a block whose code is at hand.
std::vector<double> evaluatedInDouble(const EvalCase& request, const ReferenceCode& code);

} // namespace patina
