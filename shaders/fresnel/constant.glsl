// SPDX-License-Identifier: MIT-0
#include "lib/incidence.glsl"

// The same at every angle.
vec3 constantFresnel(Incidence i, ConstantFresnel p) {
    return p.f0;
}

vec3 constantFresnelTint(ConstantFresnel p) {
    return p.color;
}
