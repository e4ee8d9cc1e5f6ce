// SPDX-License-Identifier: MIT-0
#include "lib/fresnel.glsl"

// Schlick 1994, equation 15, per channel.
vec3 schlickFresnel(Incidence i, SchlickFresnel p) {
    return p.f0 + (vec3(1.0) - p.f0) * pow5(i.versine);
}

vec3 schlickFresnelTint(SchlickFresnel p) {
    return p.color;
}
