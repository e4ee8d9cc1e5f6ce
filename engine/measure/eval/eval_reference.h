// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/eval/eval_case.h"
#include "measure/eval/reference_case.h"
#include "reference/reference.h"

namespace patina {

/// The library function that a case names; an error when there is none of that name or it takes
/// another number of arguments.
Result<const reference::Function*> findEvalFunction(const EvalCase& request);

/// The numbers that answer a case, in double precision. A model gives its pi f cos per channel, a
/// Fresnel block its reflectance per channel, a light its direction and then its radiance, fog the
/// share that is left, a function what it returns and then its out parameters. Blocks that were
/// not there when the program was built, or have changed since, are an error.
Result<std::vector<double>> evaluatedInDouble(const EvalCase& request);

/// The same for a block whose code is at hand.
std::vector<double> evaluatedInDouble(const EvalCase& request, const ReferenceCode& code);

} // namespace patina
