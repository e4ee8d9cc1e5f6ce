// SPDX-License-Identifier: MIT-0
// A block of a specular slot is evaluated as a model is.
#include "passes/evaluate_models.glsl"
