// SPDX-License-Identifier: MIT-0
#include "lib/elementary.glsl"
#include "lib/fresnel.glsl"

// Strauss's weight F(x) between f0 and 1, x the angle in right angles (Strauss 1990).
vec3 straussFresnel(Incidence i, StraussFresnel p) {
    float x;
    float y;
    angXY(i.c, sin2Incidence(i), x, y);
    float F = straussWeight(x, y, p.kf);
    return p.f0 + (vec3(1.0) - p.f0) * F;
}

vec3 straussFresnelTint(StraussFresnel p) {
    return p.color;
}
