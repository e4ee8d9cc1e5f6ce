// SPDX-License-Identifier: MIT-0
#include "lib/elementary.glsl"
#include "lib/incidence.glsl"

// clamp(bias + scale (1 - c)^power, 0, 1). x^0 is 1 for every x, also for x = 0.
// Fernando and Kilgard 2003, section 7.4.
vec3 empiricalFresnel(Incidence i, EmpiricalFresnel p) {
    float rise = p.power > 0.0 ? pow1m(i.c, i.versine, p.power) : 1.0;
    return vec3(clamp(p.bias + p.scale * rise, 0.0, 1.0));
}

vec3 empiricalFresnelTint(EmpiricalFresnel p) {
    return p.color;
}
