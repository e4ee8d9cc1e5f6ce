// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "material/material.h"
#include "measure/eval/eval_case.h"

namespace patina {

/// Returns every function of the block with each of its programs: its compiled choices, accuracy
/// levels and what can fill its slot (with its own compiled choices), such that every two choices
/// meet in some case. Other values are the defaults. Empty for a block of a kind that cannot be
/// evaluated.
std::vector<EvalCase> sweepVariants(const Catalog& catalog, const Block& block);

/// Returns the model of a material with the material's values. It is an error where the model or
/// what fills its slot is not known.
Result<EvalCase> sweepVariant(const Catalog& catalog, const Material& material);

/// Returns the functions of a material's Fresnel block, where it is blended over a model that has
/// no slot for it; else empty.
std::vector<EvalCase> blendVariants(const Catalog& catalog, const Material& material);

/// Returns the variant itself, and then with edge-case values of its parameters and of what fills
/// its slot, such that every two values meet. What is compiled into the program does not change.
std::vector<EvalCase> sweepRows(const EvalCase& variant);

/// Returns the variant with `count` sets of values that a slider reaches, the same for every call.
std::vector<EvalCase> ordinaryRows(const EvalCase& variant, std::size_t count);

/// Returns the compiled choices of the variant for messages: "scale=normalised". Empty where the
/// block has only one program.
std::string variantText(const EvalCase& variant);

} // namespace patina
